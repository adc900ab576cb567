// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/file.h"
#include "core/project/program_job.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace burin {

namespace {

struct PostArguments {
    std::string project, output, dialect, machine, overrideReason;
    std::vector<std::int64_t> paths;
    double tolerance = 0.02;
    bool inch = false;
};

/// The first path, or a new one of all takes.
Result<StoredPath> firstPath(Project& project, const std::vector<StoredPath>& paths) {
    if (!paths.empty()) return paths.front();
    Result<StoredPath> made = standardPath(project);
    if (!made) return made;
    const Result<std::int64_t> id = project.addPath(*made);
    if (!id) return id.error();
    made->id = *id;
    return made;
}

/// The paths asked for, or the first one.
Result<std::vector<StoredPath>> chosenPaths(Project& project, const std::vector<std::int64_t>& wanted) {
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
    if (!chosen.empty()) return chosen;
    Result<StoredPath> first = firstPath(project, *paths);
    if (!first) return std::move(first).error();
    return std::vector{std::move(*first)};
}

/// A path's takes, and the tool that they were made with.
struct PathMatter {
    StoredPath path;
    std::vector<Take> takes;
    Tool tool;
};
Result<PathMatter> matterOf(const Project& project, const StoredPath& path) {
    Result<std::vector<Take>> takes = takesOf(project, path);
    if (!takes) return std::move(takes).error();
    if (takes->empty()) return Error{ErrorCode::projectIncomplete, "a recording", "burin mill", {}};
    Result<Tool> tool = toolFor(project, takes->front().info.toolId);
    if (!tool) return std::move(tool).error();
    return PathMatter{path, std::move(*takes), std::move(*tool)};
}

/// What the edits of all paths did.
struct EditedPaths {
    ProgramPaths program;
    std::vector<EditReport> reports;
    double errorBudget = 0.0; ///< mm, of the worst path
};
Result<EditedPaths> edit(const Bench& bench, const std::vector<PathMatter>& matters, Progress& progress) {
    EditedPaths edited;
    std::vector<double> allowances;
    for (const PathMatter& matter : matters) {
        Result<EvaluatedPath> path = evaluateStored(matter.takes, bench, matter.tool, matter.path, progress);
        if (!path) return std::move(path).error();
        edited.program.paths.push_back(std::move(path->path));
        edited.reports.insert(edited.reports.end(), path->reports.begin(), path->reports.end());
        edited.errorBudget = std::max(edited.errorBudget, path->errorBudget);
        // What it leaves on the part in the end.
        const auto least =
            std::ranges::min_element(matter.takes, {}, [](const Take& take) { return take.info.allowance; });
        allowances.push_back(least->info.allowance);
        if (std::ranges::find(edited.program.tools, matter.tool.id, &Tool::id) == edited.program.tools.end())
            edited.program.tools.push_back(matter.tool);
    }
    edited.program = inOrder(std::move(edited.program), allowances);
    return edited;
}

int runPost(const PostArguments& arguments, CommandContext& context) {
    context.stage("Opening");
    Result<Project> project = Project::open(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<std::vector<StoredPath>> stored = chosenPaths(*project, arguments.paths);
    if (!stored) return context.fail(stored.error());
    std::vector<PathMatter> matters;
    for (const StoredPath& path : *stored) {
        Result<PathMatter> matter = matterOf(*project, path);
        if (!matter) return context.fail(matter.error());
        matters.push_back(std::move(*matter));
    }
    Result<Bench> bench = makeBench(*project, matters.front().tool, arguments.machine, context.progress());
    if (!bench) return context.fail(bench.error());

    context.stage("Editing");
    const Result<EditedPaths> edited = edit(*bench, matters, context.progress());
    if (!edited) return context.fail(edited.error());

    context.stage("Posting and checking");
    ProgramRequest request;
    request.name = std::filesystem::path(arguments.output).filename().string();
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());
    request.dialect = dialectFor(arguments.dialect, *target, bench->machine);
    request.gougeTolerance = arguments.tolerance;
    request.units = arguments.inch ? NcUnits::inch : NcUnits::millimetre;
    request.overrideReason = arguments.overrideReason;
    const Result<CheckedProgram> program = makeProgram(*bench, edited->program, request, context.progress());
    if (!program) return context.fail(program.error());

    nlohmann::json answer = jsonOf(program->report);
    answer["program"] = nullptr;
    answer["blocks"] = program->parsed.blocks;
    answer["edits"] = jsonOf(edited->reports);
    answer["error_budget_mm"] = edited->errorBudget;
    answer["work_offset_mm"] = jsonOf(bench->setup.workOffset);
    answer["tool"] = jsonOf(bench->tool);
    answer["tools"] = nlohmann::json::array();
    for (const Tool& tool : edited->program.tools) answer["tools"].push_back(jsonOf(tool));
    answer["passed"] = program->passed();
    answer["lint"] = jsonOf(program->lint);
    const std::string verdict = textOf(program->report, arguments.tolerance) + textOf(program->lint);
    answer["overridden"] = program->overridden;
    if (!program->released()) {
        context.answer(answer, verdict);
        context.message("\"" + arguments.output +
                        "\" was not written: the program is refused. With --override and a reason it is written, and "
                        "its header says so.");
        return static_cast<int>(ErrorClass::checkFailed);
    }
    if (const Result<void> written = writeFileAtomically(arguments.output, program->text); !written)
        return context.fail(written.error());
    const StoredProgram kept{request.name, request.dialect, bench->machine.id, program->text,
                             jsonOf(program->report).dump()};
    if (const Result<void> added = project->addProgram(kept); !added) return context.fail(added.error());
    if (const Result<void> saved = project->save(); !saved) return context.fail(saved.error());
    answer["program"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    context.answer(answer, arguments.output + ": " + std::to_string(program->parsed.blocks) + " blocks\n" + verdict);
    return 0;
}

} // namespace

void registerPost(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<PostArguments>();
    CLI::App* command = program.add_subcommand("post", "Write a path as a program, once the program passes its check");
    command->add_option("PROJECT", arguments->project, "Project file (.burin)")->required();
    command->add_option("-o,--output", arguments->output, "Program to write")->required();
    command->add_flag("--inch", arguments->inch, "Lengths and feeds of the program in inches (G20)");
    command->add_option("--dialect", arguments->dialect,
                        "Dialect of the control; without it the project's, or the machine's");
    command->add_option("--machine", arguments->machine, "Machine; without it the project's");
    command
        ->add_option(
            "--path", arguments->paths,
            "Paths of one program, with a tool each if they like; without it the first, or a new one of all takes")
        ->delimiter(',');
    command->add_option("--tolerance", arguments->tolerance, "Deepest gouge that passes, mm")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command
        ->add_option("--override", arguments->overrideReason,
                     "Why the program is wanted even where its check refuses it; stands in its header")
        ->check([](const std::string& reason) {
            return reason.find_first_not_of(" \t\n") == std::string::npos ? "give a reason in words" : std::string();
        });
    addJsonFlag(*command, context);
    command->callback([arguments, &context, &status] { status = runPost(*arguments, context); });
}

} // namespace burin
