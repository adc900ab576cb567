// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/picture.h"
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/picture_options.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/document/companions.h"
#include "core/job/job_paths.h"
#include "core/job/pass_figures.h"
#include "core/job/path_values.h"
#include "core/job/recorded_cuts.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace burin {

namespace {

struct ProjectPictureArguments {
    std::string project, output, colour;
    std::vector<std::int64_t> paths;
    bool excess = false;
    PictureOptions options;
};

/// A tool is needed to make a workpiece: that of the first take, or the default of `mill`.
Result<Tool> anyTool(const Project& project) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    return toolFor(project, takes->empty() ? "ball-6" : takes->front().toolId);
}

/// Errors: nameUnknown (a path), those of evaluateInJob.
Result<std::vector<std::shared_ptr<const EvaluatedPath>>> evaluatedPaths(const Project& project,
                                                                         const MillingContext& milling,
                                                                         const std::vector<std::int64_t>& wanted,
                                                                         Progress& progress) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    std::string known;
    for (const StoredPath& path : *paths) known += (known.empty() ? "" : ", ") + std::to_string(path.id);
    std::vector<std::shared_ptr<const EvaluatedPath>> evaluated;
    for (const std::int64_t id : wanted) {
        const auto found = std::ranges::find(*paths, id, &StoredPath::id);
        if (found == paths->end()) return Error{ErrorCode::nameUnknown, "path", std::to_string(id), known};
        Result<EvaluatedPath> path = evaluateInJob(project, milling, *found, progress);
        if (!path) return std::move(path).error();
        evaluated.push_back(std::make_shared<const EvaluatedPath>(std::move(*path)));
    }
    return evaluated;
}

/// The values by which the first path is coloured. Errors: nameUnknown, those of figureMatter, strokesOf and
/// pathValues.
Result<std::shared_ptr<const PathValues>> valuesOf(const Project& project, const MillingContext& milling,
                                                   const ProjectPictureArguments& arguments,
                                                   const std::shared_ptr<const EvaluatedPath>& path,
                                                   Progress& progress) {
    const PathQuantity quantity = *pathQuantityFromId(arguments.colour);
    const Result<FigureMatter> matter = figureMatter(project, *path);
    if (!matter) return matter.error();
    const Result<std::vector<StoredPath>> stored = project.paths();
    if (!stored) return stored.error();
    const auto own = std::ranges::find(*stored, arguments.paths.front(), &StoredPath::id);
    const Result<std::vector<SourceStrokes>> sources = strokesOf(project, *own);
    if (!sources) return sources.error();
    const Result<Tool> tool = toolFor(project, path->path.toolId);
    if (!tool) return tool.error();
    Result<PathValues> values = pathValues(quantity, {path, *tool}, matter->before, *sources, milling, progress);
    if (!values) return std::move(values).error();
    return std::make_shared<const PathValues>(std::move(*values));
}

/// The workpiece as the takes left it, with fixtures and limits.
Result<PictureContent> contentOf(const ProjectPictureArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return project.error();
    const Result<Tool> tool = anyTool(*project);
    if (!tool) return tool.error();
    Result<MillingContext> made =
        makeMillingContext(*project, *tool, machineFor(*project, {}, context), context.progress());
    if (!made) return std::move(made).error();
    const auto milling = std::make_shared<MillingContext>(std::move(*made));
    context.stage(BURIN_TEXT("Command", "Replaying the takes"));
    if (const Result<void> replayed = replayTakes(*project, *milling, context.progress()); !replayed)
        return replayed.error();
    context.stage(BURIN_TEXT("Command", "Editing"));
    auto paths = evaluatedPaths(*project, *milling, arguments.paths, context.progress());
    if (!paths) return std::move(paths).error();
    PictureContent content;
    content.workpiece = milling->embedded.workpiece.snapshot();
    content.part = milling->partModel;
    content.obstacles = milling->surroundings();
    content.paths = std::move(*paths);
    if (arguments.excess && milling->partModel->bodies.empty()) // free carving
        return Error{ErrorCode::argumentInvalid, "--excess", arguments.project, "a model with at least one body"};
    if (arguments.excess) content.left = ExcessColours{{milling, &milling->part}, {}};
    if (!arguments.colour.empty()) {
        auto values = valuesOf(*project, *milling, arguments, content.paths.front(), context.progress());
        if (!values) return std::move(values).error();
        content.values = std::move(*values);
    }
    return content;
}

int runPicture(const ProjectPictureArguments& arguments, CommandContext& context) {
    const std::array<std::filesystem::path, 1> inputs{arguments.project};
    if (const Result<void> free = checkOutput("--output", arguments.output, inputs); !free)
        return context.fail(free.error());
    if (const Result<void> readable = checkPictureOptions(arguments.options); !readable)
        return context.fail(readable.error());
    Result<PictureContent> content = contentOf(arguments, context);
    if (!content) return context.fail(content.error());
    context.stage(BURIN_TEXT("Command", "Drawing"));
    if (const Result<void> drawn = writePicture(std::move(*content), arguments.options, arguments.output); !drawn)
        return context.fail(drawn.error());
    const std::string file = std::filesystem::absolute(arguments.output).lexically_normal().string();
    context.answer({{"picture", file}}, worded(BURIN_TEXT("Command", "picture  %1"), {file}));
    return 0;
}

} // namespace

void registerPicture(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ProjectPictureArguments>();
    const CommandParser command =
        program.command("picture", BURIN_TEXT("Help", "Draw a project's workpiece as its takes left it"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command.option("-o,--output", arguments->output, BURIN_TEXT("Help", "Picture to write (.png)")).required();
    const Argument path = command
                              .option("--path", arguments->paths,
                                      BURIN_TEXT("Help", "Paths to draw, the first in the colours of its moves"))
                              .separatedBy(',');
    std::vector<std::string> quantities;
    for (const PathQuantity quantity : pathQuantities) quantities.emplace_back(idOf(quantity));
    command
        .option("--colour", arguments->colour,
                BURIN_TEXT("Help", "Colour the first path by this quantity, with a scale, instead of by its moves"))
        .choices(quantities)
        .needs(path);
    command.flag("--excess", arguments->excess,
                 BURIN_TEXT("Help", "Colour the workpiece by the stock that is left on the part, with a scale"));
    addPictureOptions(command, arguments->options);
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runPicture(*arguments, context); });
}

} // namespace burin
