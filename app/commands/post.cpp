// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/file.h"
#include "core/project/program_job.h"

#include <CLI/CLI.hpp>

namespace burin {

namespace {

struct PostArguments {
    std::string project, output, dialect, machine, overrideReason;
    std::int64_t path = 0;
    double tolerance = 0.02;
};

/// The path asked for, the first one, or a new one of all takes.
Result<StoredPath> chosenPath(Project& project, std::int64_t wanted) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    std::string known;
    for (const StoredPath& path : *paths) {
        if (wanted == 0 || path.id == wanted) return path;
        known += (known.empty() ? "" : ", ") + std::to_string(path.id);
    }
    if (wanted != 0) return Error{ErrorCode::nameUnknown, "path", std::to_string(wanted), known};
    Result<StoredPath> made = standardPath(project);
    if (!made) return made;
    const Result<std::int64_t> id = project.addPath(*made);
    if (!id) return id.error();
    made->id = *id;
    return made;
}

/// Tool of a path: that of its first take.
Result<std::string> toolOf(const Project& project, const StoredPath& path) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    for (const TakeInfo& take : *takes)
        if (!path.takes.empty() && take.id == path.takes.front()) return take.toolId;
    return Error{ErrorCode::projectIncomplete, "a recording", "burin mill", {}};
}

int runPost(const PostArguments& arguments, CommandContext& context) {
    context.stage("Opening");
    Result<Project> project = Project::open(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> stored = chosenPath(*project, arguments.path);
    if (!stored) return context.fail(stored.error());
    const Result<std::string> toolId = toolOf(*project, *stored);
    if (!toolId) return context.fail(toolId.error());
    const Result<Tool> tool = toolFor(*project, *toolId);
    if (!tool) return context.fail(tool.error());
    Result<Bench> bench = makeBench(*project, *tool, arguments.machine, context.progress());
    if (!bench) return context.fail(bench.error());

    context.stage("Editing");
    const Result<EvaluatedPath> path = evaluateStored(*project, *bench, *stored, context.progress());
    if (!path) return context.fail(path.error());

    context.stage("Posting and checking");
    ProgramRequest request;
    request.name = std::filesystem::path(arguments.output).filename().string();
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());
    request.dialect = dialectFor(arguments.dialect, *target, bench->machine);
    request.gougeTolerance = arguments.tolerance;
    request.overrideReason = arguments.overrideReason;
    const Result<CheckedProgram> program = makeProgram(*bench, path->path, request, context.progress());
    if (!program) return context.fail(program.error());

    nlohmann::json answer = jsonOf(program->report);
    answer["program"] = nullptr;
    answer["blocks"] = program->parsed.blocks;
    answer["edits"] = jsonOf(path->reports);
    answer["error_budget_mm"] = path->errorBudget;
    answer["work_offset_mm"] = jsonOf(bench->setup.workOffset);
    answer["tool"] = jsonOf(bench->tool);
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
    command->add_option("--dialect", arguments->dialect,
                        "Dialect of the control; without it the project's, or the machine's");
    command->add_option("--machine", arguments->machine, "Machine; without it the project's");
    command->add_option("--path", arguments->path, "Path; without it the first, or a new one of all takes");
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
