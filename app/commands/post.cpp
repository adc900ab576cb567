// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/commands/restart.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/staged_file.h"
#include "core/base/steps.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/job/job_paths.h"
#include "core/job/kept_program.h"
#include "core/job/setup_title.h"

#include <algorithm>
#include <span>

namespace burin {

namespace {

struct PostArguments {
    std::string project, output, dialect, machine, overrideReason;
    std::vector<std::int64_t> paths;
    double tolerance = 0.02;
    std::string units;
    std::uint32_t from = 0; ///< line of the program posted before; 0: the whole program
    std::string interrupted;
};

int runFrom(const PostArguments& arguments, CommandContext& context) {
    return runRestart({arguments.project, arguments.output, arguments.interrupted, arguments.from, arguments.dialect,
                       arguments.machine, arguments.units, arguments.overrideReason, arguments.tolerance},
                      context);
}

/// The requested paths, or the first one of each tool.
Result<std::vector<StoredPath>> chosenPaths(Project& project, const std::vector<std::int64_t>& wanted) {
    if (wanted.empty()) return jobPaths(project);
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    std::string known;
    for (const StoredPath& path : *paths) known += (known.empty() ? "" : ", ") + std::to_string(path.id);
    std::vector<StoredPath> chosen;
    for (const std::int64_t id : wanted) {
        const auto found = std::ranges::find(*paths, id, &StoredPath::id);
        if (found == paths->end()) return Error{ErrorCode::nameUnknown, "path", std::to_string(id), known};
        chosen.push_back(*found);
    }
    return chosen;
}

int runPost(const PostArguments& arguments, CommandContext& context) {
    std::vector<std::filesystem::path> inputs{arguments.project};
    if (!arguments.interrupted.empty()) inputs.emplace_back(arguments.interrupted);
    if (const Result<void> free = checkOutput("--output", arguments.output, inputs); !free)
        return context.fail(free.error());
    if (arguments.from > 0) return runFrom(arguments, context);
    context.stage(BURIN_TEXT("Command", "Opening"));
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<std::vector<StoredPath>> stored = chosenPaths(**project, arguments.paths);
    if (!stored) return context.fail(stored.error());
    std::vector<PathMatter> matters;
    for (const StoredPath& path : *stored) {
        Result<PathMatter> matter = matterOf(**project, path);
        if (!matter) return context.fail(matter.error());
        matters.push_back(std::move(*matter));
    }
    Result<MillingContext> milling = makeMillingContext(
        **project, matters.front().tool, machineFor(**project, arguments.machine, context), context.progress());
    if (!milling) return context.fail(milling.error());

    context.stage(BURIN_TEXT("Command", "Editing"));
    const Result<EvaluatedPaths> edited = evaluateInOrder(*milling, std::move(matters), context.progress());
    if (!edited) return context.fail(edited.error());

    context.stage(BURIN_TEXT("Command", "Posting and checking"));
    ProgramRequest request;
    request.name = std::filesystem::path(arguments.output).filename().string();
    const Result<ProgramTarget> target = (*project)->programTarget();
    if (!target) return context.fail(target.error());
    const Result<std::string> title = setupTitle(**project);
    if (!title) return context.fail(title.error());
    request.setupName = *title;
    request.dialect = dialectFor(arguments.dialect, *target, milling->machine);
    request.gougeTolerance = arguments.tolerance;
    request.units = ncUnitsFromId(arguments.units).value_or(target->units);
    request.overrideReason = arguments.overrideReason;
    const Result<CheckedProgram> program = makeProgram(*milling, edited->program, request, context.progress());
    if (!program) return context.fail(program.error());

    nlohmann::json answer = jsonOf(program->report);
    answer["program"] = nullptr;
    answer["blocks"] = program->parsed.blocks;
    answer["edits"] = jsonOf(edited->reports);
    answer["error_budget_mm"] = edited->errorBudget;
    answer["work_offset_mm"] = burin::jsonOf(milling->setup.workOffset);
    answer["machine"] = jsonOf(milling->machine);
    answer["tool"] = jsonOf(milling->tool);
    answer["tools"] = nlohmann::json::array();
    for (const Tool& tool : edited->program.tools) answer["tools"].push_back(jsonOf(tool));
    answer["passed"] = program->passed();
    answer["lint"] = jsonOf(program->lint);
    const std::vector<std::string> doubts = doubtsOf(*milling->model, milling->embedded);
    answer["part_warnings"] = doubts;
    const Result<std::vector<BadFit>> bad =
        badFits(*milling->model, milling->setup, milling->obstacles, context.progress());
    if (!bad) return context.fail(bad.error());
    answer["fixture_warnings"] = jsonOf(*bad);
    const std::string verdict = textOf(*program, arguments.tolerance, milling->machine) +
                                textOfEntries(edited->reports) + textOfOmissions(edited->reports) +
                                textOfDoubts(*milling->model, milling->embedded) + textOf(*bad);
    answer["overridden"] = program->overridden;
    answer["slowed_moves"] = program->slowed;
    if (!program->released()) {
        context.answer(answer, verdict);
        context.message(notWritten(arguments.output));
        return static_cast<int>(ErrorClass::checkFailed);
    }
    Result<StagedFile> output = StagedFile::containing(arguments.output, program->text);
    if (!output) return context.fail(output.error());
    const StoredProgram kept{request.name, request.dialect, milling->machine.id, program->text,
                             jsonOf(program->report).dump()};
    const Result<void> saved =
        inOrder([&] { return (*project)->addProgram(kept); },
                [&] { return keepVerdict(**project, *program, milling->machine.id, request.units); },
                [&] { return project->save(std::span(&*output, 1)); });
    if (!saved) {
        const QString standing = standingOutputs(std::span(&*output, 1));
        return context.fail(
            saved.error(),
            standing.isEmpty()
                ? QString::fromStdString(
                      worded(BURIN_TEXT("Command", "neither \"%1\" nor the project was changed"), {arguments.output}))
                : standing);
    }
    tellKeptEarlier(context, **project);
    answer["program"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    context.answer(answer, worded(BURIN_TEXT("Command", "%1: %2 blocks"),
                                  {arguments.output, std::to_string(program->parsed.blocks)}) +
                               "\n" + verdict);
    return 0;
}

} // namespace

void registerPost(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<PostArguments>();
    const CommandParser command =
        program.command("post", BURIN_TEXT("Help", "Write a path as a program, once the program passes its check"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command.option("-o,--output", arguments->output, BURIN_TEXT("Help", "Program to write")).required();
    command
        .option("--units", arguments->units,
                BURIN_TEXT("Help", "Units of the program: mm (G21) or inch (G20) (default: the project's)"))
        .choices({"mm", "inch"});
    command.option("--dialect", arguments->dialect,
                   BURIN_TEXT("Help", "Dialect of the control (default: the project's, or the machine's)"));
    command.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    command
        .option("--path", arguments->paths,
                BURIN_TEXT("Help", "Paths of the program, which may have different tools (default: the first path of "
                                   "each tool that milled)"))
        .separatedBy(',');
    command.option("--tolerance", arguments->tolerance, BURIN_TEXT("Help", "Deepest gouge that passes, mm"))
        .range(0.0, 10.0)
        .showDefault();
    const Argument from =
        command
            .option("--from", arguments->from,
                    BURIN_TEXT(
                        "Help",
                        "Restart after a broken tool: line of the program that was posted last; the lines before it "
                        "are done. Writes the rest, which leads back into the cut and is checked on the stock that is "
                        "left"))
            .range(1, 100000000)
            .valueName(BURIN_TEXT("Argument", "LINE"));
    command
        .option(
            "--program", arguments->interrupted,
            BURIN_TEXT("Help", "With --from: the interrupted program (default: the one that the project posted last)"))
        .needs(from)
        .valueName(BURIN_TEXT("Argument", "FILE"));
    command
        .option("--override", arguments->overrideReason,
                BURIN_TEXT("Help", "Write the program even if its check refuses it; states this reason in its header"))
        .notBlank(BURIN_TEXT("Command", "state a reason"));
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runPost(*arguments, context); });
}

} // namespace burin
