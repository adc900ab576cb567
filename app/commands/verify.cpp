// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/face_report.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/file.h"
#include "core/document/companions.h"
#include "core/exchange/volume_output.h"
#include "core/job/job_paths.h"
#include "core/job/program_job.h"
#include "core/job/program_time.h"
#include "core/nc/dialect_library.h"
#include "core/verify/deviation_scale.h"
#include "core/verify/report_json.h"
#include "core/volume/operations/fingerprint.h"
#include "ui/scene/deviation_map.h"

#include <algorithm>
#include <array>
#include <optional>

namespace burin {

namespace {

struct VerifyArguments {
    std::string program, project, tool, map, machine, dialect;
    double tolerance = 0.02, allowance = 0.0;
    std::optional<double> excess, until;
    std::size_t exactSamples = 500;
    std::string workpiece, faceTable;
    bool faces = false;
};

/// The tolerances for the colours of the map and the shares of the faces.
DeviationTolerance shownTolerance(const VerifyArguments& arguments) {
    DeviationTolerance tolerance;
    tolerance.gouge = arguments.tolerance;
    if (arguments.excess.value_or(0.0) > 0.0) tolerance.excess = *arguments.excess;
    tolerance.allowance = arguments.allowance;
    return tolerance;
}

/// The requested tool, or that of the first take.
Result<Tool> chosenTool(const Project& project, const std::string& id) {
    if (!id.empty()) return toolFor(project, id);
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    if (sources->empty()) return Error{ErrorCode::projectIncomplete, "a tool", "--tool NAME", {}};
    return toolFor(project, sources->front().toolId);
}

/// The colour scale of the map, from the deepest gouge to the most excess stock.
nlohmann::json jsonOf(const DeviationScale& scale) {
    nlohmann::json marks = nlohmann::json::array();
    for (const DeviationScale::Mark& mark : scale.marks())
        marks.push_back(
            {{"deviation_mm", mark.deviation}, {"colour", mark.colour}, {"tolerance_limit", mark.ofTolerance}});
    return marks;
}

/// Writes the workpiece as the program leaves it at a time, and adds the state at that time to the answer.
Result<void> writeWorkpiece(const CheckedProgram& checked, const MillingContext& milling,
                            const VerifyArguments& arguments, nlohmann::json& answer, Progress& progress) {
    Result<ProgramTime> spread = programTime(checked, milling.machine, milling.setup.workOffset, progress);
    if (!spread) return std::move(spread).error();
    const double seconds = std::min(arguments.until.value_or(spread->time.seconds()), spread->time.seconds());
    answer["workpiece_at_s"] = seconds;
    answer["workpiece_at_line"] = nullptr;
    RecordedWork work;
    if (!spread->time.tracks.empty()) {
        const TakeMoment moment = spread->time.momentAt(seconds);
        answer["workpiece_at_line"] = checked.parsed.motions[spread->motionAt(moment)].line;
        for (const SharedCuts& cuts : spread->time.cuts)
            if (cuts->take <= moment.take) work.cuts.push_back(*cuts);
        work.cuts.back().end = work.cuts.back().motions.countWithin(moment.samples);
    }
    Result<RunVolume> workpiece = workpieceOf(
        work, [&] { return milling.stock->makeStock(progress); }, progress);
    if (!workpiece) return std::move(workpiece).error();
    const Result<WrittenVolume> written = writeAnyVolume(arguments.workpiece, workpiece->snapshot(), progress);
    if (!written) return written.error();
    answer["workpiece"] = written->file;
    answer["workpiece_hash"] = fingerprintText(fingerprint(workpiece->snapshot()));
    return {};
}

/// Inspects each face of the part, adds the results to the answer, the worst first, and writes the table if requested.
Result<std::string> inspectFaces(const CheckedProgram& checked, const MillingContext& milling,
                                 const VerifyArguments& arguments, nlohmann::json& answer, Progress& progress) {
    const Result<std::vector<PartFacePatch>> patches = partFaces(*milling.partModel, {}, progress);
    if (!patches) return patches.error();
    Result<std::vector<FaceQuality>> faces =
        faceQualities(*patches, checked.report.deviations, shownTolerance(arguments), progress);
    if (!faces) return std::move(faces).error();
    sortByQuality(*faces);
    answer["faces"] = jsonOf(*faces);
    if (arguments.faceTable.empty()) return textOf(*faces);
    if (const Result<void> written = writeFileAtomically(arguments.faceTable, faceTable(*faces, ',')); !written)
        return written.error();
    answer["face_table"] = std::filesystem::absolute(arguments.faceTable).lexically_normal().string();
    return textOf(*faces);
}

int runVerify(const VerifyArguments& arguments, CommandContext& context) {
    const std::array<std::filesystem::path, 2> inputs{arguments.program, arguments.project};
    if (!arguments.map.empty())
        if (const Result<void> free = checkOutput("--map", arguments.map, inputs); !free)
            return context.fail(free.error());
    if (!arguments.workpiece.empty())
        if (const Result<void> free = checkOutput("--workpiece", arguments.workpiece, inputs); !free)
            return context.fail(free.error());
    if (!arguments.faceTable.empty())
        if (const Result<void> free = checkOutput("--face-table", arguments.faceTable, inputs); !free)
            return context.fail(free.error());
    Result<std::string> text = readFile(arguments.program);
    if (!text) return context.fail(text.error());
    if (text->empty()) return context.fail({ErrorCode::fileEmpty, arguments.program, {}, {}});
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<Tool> tool = chosenTool(*project, arguments.tool);
    if (!tool) return context.fail(tool.error());
    const Result<MillingContext> milling =
        makeMillingContext(*project, *tool, machineFor(*project, arguments.machine, context), context.progress());
    if (!milling) return context.fail(milling.error());

    context.stage(BURIN_TEXT("Command", "Checking"));
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());
    ProgramRequest request;
    request.dialect = dialectFor(arguments.dialect, *target, milling->machine);
    if (const auto known = loadDialect(request.dialect); !known) return context.fail(known.error());
    Result<std::vector<Tool>> tools = project->tools();
    if (!tools) return context.fail(tools.error());
    request.tools = arguments.tool.empty() ? std::move(*tools) : std::vector{*tool}; // the named tool is the only one
    request.anyNumber = !arguments.tool.empty();
    request.gougeTolerance = arguments.tolerance;
    request.exactSamples = arguments.exactSamples;
    request.excessTolerance = arguments.excess.value_or(request.excessTolerance);
    const bool follows = arguments.excess ? *arguments.excess > 0.0 : isPosted(*text);
    if (follows) {
        Result<std::vector<Path>> promised = promisedPaths(*project, *milling, context.progress());
        if (!promised) return context.fail(promised.error());
        request.promised = std::make_shared<const std::vector<Path>>(std::move(*promised));
    }
    const Result<CheckedProgram> checked =
        checkProgram(*milling, std::move(*text), arguments.program, request, context.progress());
    if (!checked) return context.fail(checked.error());

    nlohmann::json answer = jsonOf(checked->report);
    if (context.json) answer.update(nlohmann::json::parse(loadsToJson(checked->report))); // not reported anywhere else
    answer["passed"] = checked->passed();
    answer["lint"] = jsonOf(checked->lint);
    answer["program"] = std::filesystem::absolute(arguments.program).lexically_normal().string();
    answer["blocks"] = checked->parsed.blocks;
    answer["machine"] = jsonOf(milling->machine);
    const std::vector<std::string> doubts = doubtsOf(*milling->model, milling->embedded);
    answer["part_warnings"] = doubts;
    const Result<std::vector<BadFit>> bad =
        badFits(*milling->model, milling->setup, milling->obstacles, context.progress());
    if (!bad) return context.fail(bad.error());
    answer["fixture_warnings"] = jsonOf(*bad);
    answer["tool"] = jsonOf(checked->tools.front());
    answer["work_offset_mm"] = burin::jsonOf(milling->setup.workOffset);
    if (!arguments.map.empty()) {
        const DeviationTolerance tolerance = shownTolerance(arguments);
        const auto written = writeDeviationMap(checked->report.deviations, tolerance, arguments.map);
        if (!written) return context.fail(written.error());
        answer["map_scale"] = jsonOf(DeviationScale(tolerance));
        answer["map"] = std::filesystem::absolute(arguments.map).lexically_normal().string();
    }
    if (!arguments.workpiece.empty())
        if (const Result<void> written = writeWorkpiece(*checked, *milling, arguments, answer, context.progress());
            !written)
            return context.fail(written.error());
    std::string faces; // the last: a failure leaves the files that were written before
    if (arguments.faces || !arguments.faceTable.empty()) {
        context.stage(BURIN_TEXT("Command", "Inspecting the faces"));
        Result<std::string> inspected = inspectFaces(*checked, *milling, arguments, answer, context.progress());
        if (!inspected) return context.fail(inspected.error());
        faces = std::move(*inspected);
    }
    context.answer(answer, textOf(*checked, arguments.tolerance, milling->machine) + faces +
                               textOfDoubts(*milling->model, milling->embedded) + textOf(*bad));
    return checked->passed() ? 0 : static_cast<int>(ErrorClass::checkFailed);
}

} // namespace

void registerVerify(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<VerifyArguments>();
    const CommandParser command =
        program.command("verify", BURIN_TEXT("Help", "Re-simulate a program on a project's setup and judge it"));
    command.positional(BURIN_TEXT("Argument", "PROGRAM"), arguments->program, BURIN_TEXT("Help", "NC program"))
        .required();
    command.option("--project", arguments->project, BURIN_TEXT("Help", "Project file (.burin)")).required();
    command.option("--tool", arguments->tool,
                   BURIN_TEXT("Help", "Tool of the whole program (default: the project's tools by their numbers, or "
                                      "the tool of the first take)"));
    command.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    command.option("--dialect", arguments->dialect,
                   BURIN_TEXT("Help", "Dialect of the program (default: the project's, or the machine's)"));
    command.option("--tolerance", arguments->tolerance, BURIN_TEXT("Help", "Deepest gouge that passes, mm"))
        .range(0.0, 10.0)
        .showDefault();
    command
        .option("--excess", arguments->excess,
                BURIN_TEXT("Help", "Largest allowed difference between the stock left on the part and what the "
                                   "project's paths leave, and largest excess at blended corners, mm; 0: not judged "
                                   "(default: 0.1, and the project's paths count only for programs that Burin posted)"))
        .range(0.0, 100.0);
    command
        .option("--exact", arguments->exactSamples,
                BURIN_TEXT("Help", "Number of worst points that are judged on exact geometry"))
        .range(0, 100000)
        .showDefault();
    command.option("--map", arguments->map,
                   BURIN_TEXT("Help", "Write the deviation map as a VTK file (.vtp), in the colours of the window"));
    command.flag("--faces", arguments->faces,
                 BURIN_TEXT("Help", "List the faces of the part with gouge, stock left and share in tolerance, the "
                                    "worst first"));
    command.option("--face-table", arguments->faceTable,
                   BURIN_TEXT("Help", "Write the list of --faces as a table (.csv)"));
    command.option(
        "--workpiece", arguments->workpiece,
        BURIN_TEXT("Help", "Write the workpiece that the program leaves, in the forms of \"volume export\""));
    command
        .option("--until", arguments->until,
                BURIN_TEXT("Help", "With --workpiece: as it stands at this time of the program, s"))
        .range(0.0, 1e9);
    command
        .option(
            "--allowance", arguments->allowance,
            BURIN_TEXT("Help", "Stock to leave on the part, mm: within tolerance in the map's colours and on faces"))
        .range(0.0, 100.0)
        .showDefault();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runVerify(*arguments, context); });
}

} // namespace burin
