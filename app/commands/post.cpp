// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/file.h"
#include "core/project/job_paths.h"
#include "core/project/kept_program.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace burin {

namespace {

struct PostArguments {
    std::string project, output, dialect, machine, overrideReason;
    std::vector<std::int64_t> paths;
    double tolerance = 0.02;
    std::string units;
};

/// The paths asked for, or the first one of each tool.
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
    std::error_code absent;
    if (std::filesystem::equivalent(arguments.project, arguments.output, absent))
        return context.fail(
            {ErrorCode::argumentInvalid, "--output", arguments.output, "a file other than the project"});
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
    const Result<EvaluatedPaths> edited = evaluateInOrder(*bench, matters, context.progress());
    if (!edited) return context.fail(edited.error());

    context.stage("Posting and checking");
    ProgramRequest request;
    request.name = std::filesystem::path(arguments.output).filename().string();
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());
    request.dialect = dialectFor(arguments.dialect, *target, bench->machine);
    request.gougeTolerance = arguments.tolerance;
    request.units = ncUnitsFromId(arguments.units).value_or(target->units);
    request.overrideReason = arguments.overrideReason;
    const Result<CheckedProgram> program = makeProgram(*bench, edited->program, request, context.progress());
    if (!program) return context.fail(program.error());

    nlohmann::json answer = jsonOf(program->report);
    answer["program"] = nullptr;
    answer["blocks"] = program->parsed.blocks;
    answer["edits"] = jsonOf(edited->reports);
    answer["error_budget_mm"] = edited->errorBudget;
    answer["work_offset_mm"] = burin::jsonOf(bench->setup.workOffset);
    answer["tool"] = jsonOf(bench->tool);
    answer["tools"] = nlohmann::json::array();
    for (const Tool& tool : edited->program.tools) answer["tools"].push_back(jsonOf(tool));
    answer["passed"] = program->passed();
    answer["lint"] = jsonOf(program->lint);
    const std::string verdict = textOf(*program, arguments.tolerance) + textOfOmissions(edited->reports);
    answer["overridden"] = program->overridden;
    if (!program->released()) {
        context.answer(answer, verdict);
        context.message("\"" + arguments.output +
                        "\" was not written: the program failed its check. To write it all the same, state a reason "
                        "with --override; its header shows the reason.");
        return static_cast<int>(ErrorClass::checkFailed);
    }
    if (const Result<void> written = writeFileAtomically(arguments.output, program->text); !written)
        return context.fail(written.error());
    const StoredProgram kept{request.name, request.dialect, bench->machine.id, program->text,
                             jsonOf(program->report).dump()};
    if (const Result<void> added = project->addProgram(kept); !added) return context.fail(added.error());
    if (const Result<void> judged = keepVerdict(*project, *program, bench->machine.id, request.units); !judged)
        return context.fail(judged.error());
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
    command
        ->add_option("--units", arguments->units,
                     "Lengths and feeds of the program: mm (G21) or inch (G20); without it the project's")
        ->check(CLI::IsMember({"mm", "inch"}));
    command->add_option("--dialect", arguments->dialect,
                        "Dialect of the control; without it the project's, or the machine's");
    command->add_option("--machine", arguments->machine, "Machine; without it the project's");
    command
        ->add_option(
            "--path", arguments->paths,
            "Paths of the program, which may have different tools; without it the first path of each tool that milled")
        ->delimiter(',');
    command->add_option("--tolerance", arguments->tolerance, "Deepest gouge that passes, mm")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command
        ->add_option("--override", arguments->overrideReason,
                     "Write the program even if its check refuses it; states this reason in its header")
        ->check([](const std::string& reason) {
            return reason.find_first_not_of(" \t\n") == std::string::npos ? "state a reason" : std::string();
        });
    addJsonFlag(*command, context);
    command->callback([arguments, &context, &status] { status = runPost(*arguments, context); });
}

} // namespace burin
