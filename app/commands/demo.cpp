// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/picture_options.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/base/staged_file.h"
#include "core/base/steps.h"
#include "core/cad/import.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/job/job_paths.h"
#include "core/job/kept_program.h"
#include "core/job/milling.h"
#include "ui/scene/picture.h"

#include <array>
#include <filesystem>
#include <limits>
#include <vector>

namespace burin {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct DemoArguments {
    std::string model, tool, output = "out", machine = "linuxcnc-mill", material = "machinable-wax";
    double seconds = 0.0, voxel = 0.0, margin = 5.0, tolerance = 0.02;
    std::uint64_t seed = 1;
    bool block = false;
    PictureOptions picture;
};

/// The results of the demo, for the answer and the report.
struct DemoResult {
    MillingContext milling;
    OperatorOutcome milled;
    EvaluatedPath path;
    CheckedProgram program;
};

/// Figure 13 b of the paper: a block of 40 × 32 × 40 voxels and a ball of radius 0.5; a voxel is taken as 0.1 mm.
Result<Setup> blockSetup(const DemoArguments& arguments) {
    Setup setup;
    setup.voxel = arguments.voxel > 0.0 ? arguments.voxel : 0.1;
    setup.marginLow = setup.marginHigh = glm::dvec3(0.0);
    setup.stockMaterial = arguments.material;
    setup.stock = {glm::dvec3(0.0), glm::dvec3(40.0, 32.0, 40.0) * setup.voxel};
    setup.workOffset = topOf(setup);
    return setup;
}

Result<Setup> partSetup(const DemoArguments& arguments, const Model& model) {
    Setup setup;
    setup.voxel = arguments.voxel > 0.0 ? arguments.voxel : 0.5;
    setup.marginLow = setup.marginHigh = glm::dvec3(arguments.margin);
    setup.stockMaterial = arguments.material;
    setup.bodyMaterials.assign(model.bodies.size(), {});
    return placeStock(model, setup);
}

/// Creates a project with part, stock, material and tool. Errors: those of importing, placing and storing.
Result<ProjectChange> makeProject(const DemoArguments& arguments, const Tool& tool, CommandContext& context) {
    Model model;
    if (!arguments.block) {
        context.stage(BURIN_TEXT("Command", "Importing"));
        const fs::path file =
            arguments.model.empty() ? resourceDirectory() / "samples/mouse.step" : fs::path(arguments.model);
        Result<Model> imported = importModel(file, ImportOptions{}, context.progress());
        if (!imported) return std::move(imported).error();
        model = std::move(*imported);
    }
    const Result<Setup> setup = arguments.block ? blockSetup(arguments) : partSetup(arguments, model);
    if (!setup) return setup.error();
    const Result<Property> material = loadMaterial(arguments.material);
    if (!material) return material.error();
    context.stage(BURIN_TEXT("Command", "Making the project"));
    Result<ProjectChange> project = ProjectChange::create(fs::path(arguments.output) / "demo.burin");
    if (!project) return project;
    Result<void> filled =
        inOrder([&] { return (*project)->setModel(model); }, [&] { return (*project)->setSetup(*setup); },
                [&] { return (*project)->setMaterials({*material}); }, [&] { return (*project)->setTool(tool); });
    if (!filled) return std::move(filled).error();
    return project;
}

/// Runs the whole job on a project. Errors: those of its stages.
Result<DemoResult> work(Project& project, const Tool& tool, const DemoArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Embedding"));
    Result<MillingContext> milling = makeMillingContext(project, tool, arguments.machine, context.progress());
    if (!milling) return std::move(milling).error();
    context.stage(BURIN_TEXT("Command", "Computing the tool's boundary"));
    OperatorRequest request;
    request.timeLimit = arguments.seconds;
    // The paper's model wax allows deep, wide cuts; the fine finishing passes remove the remaining steps.
    request.levelDepth = 1.4 * tool.cutter.diameter;
    request.finishingDepth = 2.0 * tool.cutter.diameter;
    request.roughingStepOver = 0.85 * tool.cutter.diameter;
    request.finishingStepOver = tool.cutter.diameter / 17.0;
    request.seed = arguments.seed;
    request.saves = false; // saved with everything else, at the end
    const auto field = clearanceField(*milling, request.allowance, context.progress());
    if (!field) return field.error();
    context.stage(BURIN_TEXT("Command", "Milling"));
    Result<OperatorOutcome> milled =
        millWithOperator(project, *milling, ToolBounds::borrowing(**field), request, context.progress().cancelFlag());
    if (!milled) return std::move(milled).error();

    context.stage(BURIN_TEXT("Command", "Editing"));
    Result<StoredPath> stored = standardPath(project, tool.id);
    if (!stored) return std::move(stored).error();
    const Result<std::int64_t> id = project.addPath(*stored);
    if (!id) return id.error();
    Result<EvaluatedPath> path = evaluateStored(project, *milling, *stored, context.progress());
    if (!path) return std::move(path).error();

    context.stage(BURIN_TEXT("Command", "Posting and checking"));
    ProgramRequest post;
    post.name = "demo.ngc";
    post.gougeTolerance = arguments.tolerance;
    Result<CheckedProgram> program = makeProgram(*milling, path->path, post, context.progress());
    if (!program) return std::move(program).error();
    return DemoResult{std::move(*milling), std::move(*milled), std::move(*path), std::move(*program)};
}

json jsonOf(const DemoResult& result) {
    json answer = burin::jsonOf(result.program.report);
    std::uint64_t ticks = 0, samples = 0, shank = 0;
    double removed = 0.0, drop = 0.0, p50 = 0.0, p999 = 0.0, cpuP999 = 0.0, wall = 0.0, simulated = 0.0;
    for (const TakeOutcome& take : result.milled.takes) {
        ticks += take.loop.ticks;
        samples += take.samples;
        shank += take.shankTicks;
        removed += take.removed;
        drop += take.drop;
        wall += take.loop.wallSeconds;
        simulated += take.loop.simulatedSeconds;
        p50 = std::max(p50, take.loop.workP50);
        p999 = std::max(p999, take.loop.workP999);
        cpuP999 = std::max(cpuP999, take.loop.cpuP999);
    }
    answer["program_removed_mm3"] = answer["removed_mm3"];
    answer["removed_mm3"] = removed;
    answer["workpiece_drop_mm3"] = drop;
    answer["ticks"] = ticks;
    answer["samples"] = samples;
    answer["shank_contact_ticks"] = shank;
    answer["tick_us_p50"] = p50;
    answer["tick_us_p999"] = p999;
    answer["tick_cpu_us_p999"] = cpuP999; // without the time that other programs took from the tick
    answer["milling_s"] = simulated;
    answer["milling_wall_s"] = wall;
    answer["blocks"] = result.program.parsed.blocks;
    answer["edits"] = burin::jsonOf(result.path.reports);
    answer["error_budget_mm"] = result.path.errorBudget;
    answer["work_offset_mm"] = burin::jsonOf(result.milling.setup.workOffset);
    answer["tool"] = burin::jsonOf(result.milling.tool);
    answer["voxel_mm"] = result.milling.setup.voxel;
    answer["part_volume_mm3"] = result.milling.embedded.partVolume;
    answer["model_volume_mm3"] = result.milling.model->volume();
    answer["stock_volume_mm3"] = result.milling.embedded.stockVolume;
    answer["levels_mm"] = result.milled.plan.levels;
    answer["step_over_mm"] = result.milled.plan.finishingStepOver;
    answer["truncated"] = result.milled.plan.truncated;
    return answer;
}

/// The position of the tool in the picture: a point that it cut, near the viewer and high up.
glm::dvec3 placeToShow(const Path& path) {
    constexpr glm::dvec3 towardsViewer(0.3, -0.4, 1.0);
    glm::dvec3 best(0.0);
    double nearest = -std::numeric_limits<double>::infinity();
    for (const PathPoint& point : path.points) {
        const double near = glm::dot(point.pose.tip, towardsViewer);
        if (point.kind != MoveKind::cut || near <= nearest) continue;
        nearest = near;
        best = point.pose.tip;
    }
    return best;
}

/// Draws the result without the path, whose fine passes would hide the surface.
Result<StagedFile> drawResult(const DemoResult& result, const PictureOptions& options, const fs::path& file) {
    PictureContent content;
    content.workpiece = result.program.machined;
    content.part = result.milling.partModel;
    content.tool = result.milling.tool;
    content.pose.tip = placeToShow(result.path.path);
    const Result<std::string> png = pictureOf(std::move(content), options);
    if (!png) return png.error();
    return StagedFile::containing(file, *png);
}

/// Writes program, picture and report, and the project with its verdict: all or none of them.
Result<void> writeAll(ProjectChange& project, const DemoResult& result, const DemoArguments& arguments,
                      const fs::path& folder, const json& answer) {
    std::vector<StagedFile> files;
    const auto stage = [&](Result<StagedFile> file) -> Result<void> {
        if (!file) return std::move(file).error();
        files.push_back(std::move(*file));
        return {};
    };
    if (result.program.report.passed()) {
        const StoredProgram kept{"demo.ngc", ProgramRequest{}.dialect, arguments.machine, result.program.text,
                                 burin::jsonOf(result.program.report).dump()};
        Result<void> stored =
            inOrder([&] { return project->addProgram(kept); },
                    [&] { return keepVerdict(*project, result.program, arguments.machine, ProgramRequest{}.units); },
                    [&] { return stage(StagedFile::containing(folder / "demo.ngc", result.program.text)); });
        if (!stored) return stored;
    }
    return inOrder([&] { return stage(drawResult(result, arguments.picture, folder / "demo.png")); },
                   [&] { return stage(StagedFile::containing(folder / "demo.json", answer.dump(2) + "\n")); },
                   [&] { return project.save(files); });
}

/// Checks that no output replaces the model.
Result<void> checkOutputs(const DemoArguments& arguments) {
    const fs::path folder = arguments.output;
    const std::array<fs::path, 1> inputs{arguments.model};
    for (const char* name : {"demo.burin", "demo.ngc", "demo.png", "demo.json"})
        if (Result<void> free = checkOutput("--output", folder / name, inputs); !free) return free;
    return {};
}

int runDemo(const DemoArguments& arguments, CommandContext& context) {
    if (const Result<void> readable = checkPictureOptions(arguments.picture); !readable)
        return context.fail(readable.error());
    if (const Result<void> free = checkOutputs(arguments); !free) return context.fail(free.error());
    std::error_code failed;
    fs::create_directories(arguments.output, failed);
    if (failed) return context.fail(writeError(arguments.output, failed.value()));
    const Result<Tool> tool = loadTool(!arguments.tool.empty() ? arguments.tool
                                       : arguments.block       ? "ball-1"
                                                               : "ball-6");
    if (!tool) return context.fail(tool.error());
    Result<ProjectChange> project = makeProject(arguments, *tool, context);
    if (!project) return context.fail(project.error());
    const Result<DemoResult> result = work(**project, *tool, arguments, context);
    if (!result) return context.fail(result.error());

    context.stage(BURIN_TEXT("Command", "Writing"));
    const fs::path folder = fs::absolute(arguments.output).lexically_normal();
    const bool passed = result->program.report.passed();
    json answer = jsonOf(*result);
    answer["project"] = (folder / "demo.burin").string();
    answer["program"] = passed ? json((folder / "demo.ngc").string()) : json(nullptr);
    answer["picture"] = (folder / "demo.png").string();
    answer["report"] = (folder / "demo.json").string();
    if (const Result<void> written = writeAll(*project, *result, arguments, folder, answer); !written)
        return context.fail(written.error());
    const auto line = [&](TextId text, const char* key) {
        return worded(text, {answer[key].get<std::string>()}) + "\n";
    };
    const std::string blocks = std::to_string(result->program.parsed.blocks);
    context.answer(answer,
                   line(BURIN_TEXT("Command", "project  %1"), "project") +
                       (passed ? worded(BURIN_TEXT("Command", "program  %1, %2 blocks"), {answer["program"], blocks})
                               : worded(BURIN_TEXT("Command", "program  refused, %1 blocks"), {blocks})) +
                       "\n" + line(BURIN_TEXT("Command", "picture  %1"), "picture") +
                       line(BURIN_TEXT("Command", "report   %1"), "report") +
                       textOf(result->program, arguments.tolerance, result->milling.machine));
    return passed ? 0 : static_cast<int>(ErrorClass::checkFailed);
}

} // namespace

void registerDemo(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<DemoArguments>();
    const CommandParser command =
        program.command("demo", BURIN_TEXT("Help", "Do the whole job on the sample part with a virtual operator"));
    const Argument block = command.flag("--block", arguments->block,
                                        BURIN_TEXT("Help", "Mill the block of the paper's figure 13 (b) instead"));
    command.option("--model", arguments->model, BURIN_TEXT("Help", "Another part: STEP, IGES, BREP, or a mesh"))
        .excludes(block);
    command.option("--tool", arguments->tool, BURIN_TEXT("Help", "Tool (ball-6; ball-1 with --block)"));
    command.option("--voxel", arguments->voxel, BURIN_TEXT("Help", "Edge of a voxel, mm (0.5; 0.1 with --block)"))
        .range(1e-3, 100.0);
    command.option("--seconds", arguments->seconds, BURIN_TEXT("Help", "Time limit of the operator, s; 0: none"))
        .range(0.0, 1e6);
    command.option("--margin", arguments->margin, BURIN_TEXT("Help", "Stock around the part, mm")).showDefault();
    command.option("--material", arguments->material, BURIN_TEXT("Help", "Material of the stock")).showDefault();
    command.option("--seed", arguments->seed, BURIN_TEXT("Help", "Seed of the operator's random tremor")).showDefault();
    command.option("--output", arguments->output, BURIN_TEXT("Help", "Folder for project, program, picture and report"))
        .showDefault();
    addPictureOptions(command, arguments->picture);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runDemo(*arguments, context); });
}

} // namespace burin
