// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/commands/path_compare.h"
#include "app/commands/path_pass.h"
#include "app/commands/path_program.h"
#include "app/path_report.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/job/computed_pass.h"
#include "core/job/job_paths.h"
#include "core/job/path_takes.h"
#include "core/job/take_trace.h"
#include "core/path/milling_side.h"
#include "core/recording/take_csv.h"
#include "core/setup/material_change.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

using nlohmann::json;

struct PathArguments {
    std::string project, machine, output, edit, name;
    std::string outputOption = "--output"; ///< option that specified the output
    std::int64_t path = 0, take = 0;
    std::vector<std::int64_t> takes;
    std::size_t place = 0;
    ProgramPathArguments program;
    PassArguments pass;
    CompareArguments compare;
    std::optional<std::int64_t> meantPass; ///< the pass to be deleted or recomputed
    bool outdatedOnly = false;             ///< recompute those passes only
};

int list(const PathArguments& arguments, CommandContext& context) {
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<std::vector<StoredPath>> paths = project->paths();
    if (!paths) return context.fail(paths.error());
    json answer{{"paths", json::array()}};
    std::string text = paths->empty() ? worded(BURIN_TEXT("Command", "no paths")) : "";
    for (const StoredPath& path : *paths) {
        const Result<std::vector<GeneratedInfo>> passes = passesOf(*project, path);
        if (!passes) return context.fail(passes.error());
        answer["paths"].push_back(jsonOf(path, *passes));
        text += (text.empty() ? "" : "\n") + textOf(path, *passes);
    }
    context.answer(answer, text);
    return 0;
}

/// A path has one tool: that of the first requested take, or that of the last take.
Result<std::string> toolForNew(const Project& project, const PathArguments& arguments) {
    if (arguments.takes.empty()) {
        const Result<std::vector<TakeInfo>> standing = standingTakes(project);
        if (!standing) return standing.error();
        return standing->empty() ? std::string() : newestTake(*standing).toolId;
    }
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const auto first = std::ranges::find(*takes, arguments.takes.front(), &TakeInfo::id);
    if (first == takes->end())
        return Error{ErrorCode::nameUnknown, "take", std::to_string(arguments.takes.front()), {}};
    return first->toolId;
}

int create(const PathArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    if (!arguments.pass.kind.empty())
        return addPassTo(*project, {0, arguments.name, {}, {}}, arguments.pass, arguments.machine, context);
    const Result<std::string> tool = toolForNew(**project, arguments);
    if (!tool) return context.fail(tool.error());
    Result<StoredPath> path = standardPath(**project, *tool);
    if (!path) return context.fail(path.error());
    path->name = arguments.name.empty() ? "path" : arguments.name;
    for (const std::int64_t take : arguments.takes)
        if (std::ranges::find(path->sources, PathSource{take}) == path->sources.end())
            return context.fail({ErrorCode::argumentInvalid, "--takes", std::to_string(take),
                                 worded(BURIN_TEXT("Command", "recordings made with %1, as the first one"), {*tool})});
    if (!arguments.takes.empty()) path->sources = sourcesOf(arguments.takes);
    const Result<std::int64_t> id = (*project)->addPath(*path);
    if (!id) return context.fail(id.error());
    path->id = *id;
    return saveAndAnswer(*project, *path, context);
}

/// Changes the edits of one path and saves.
int change(const PathArguments& arguments, CommandContext& context,
           const std::function<Result<void>(StoredPath&)>& changeEdits) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    Result<StoredPath> path = pathWithId(**project, arguments.path);
    if (!path) return context.fail(path.error());
    if (const Result<void> changed = changeEdits(*path); !changed) return context.fail(changed.error());
    if (const Result<void> stored = (*project)->setPath(*path); !stored) return context.fail(stored.error());
    return saveAndAnswer(*project, *path, context);
}

Result<void> applyEdit(StoredPath& path, const PathArguments& arguments) {
    const Result<Edit> edit = editFromJson(arguments.edit);
    if (!edit) return edit.error();
    if (arguments.place > path.edits.size())
        return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                     worded(BURIN_TEXT("Command", "%1 to %2"), {"0", std::to_string(path.edits.size())})};
    path.edits.insert(path.edits.begin() + static_cast<std::ptrdiff_t>(arguments.place), *edit);
    return {};
}

/// Adds one of the project's takes to a path, or removes it from the path.
int changeTakes(const PathArguments& arguments, bool added, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    Result<StoredPath> path = pathWithId(**project, arguments.path);
    if (path)
        path = added ? withTake(**project, std::move(*path), arguments.take)
                     : withoutTake(**project, std::move(*path), arguments.take);
    if (!path) return context.fail(path.error());
    if (const Result<void> stored = (*project)->setPath(*path); !stored) return context.fail(stored.error());
    return saveAndAnswer(*project, *path, context);
}

/// Adds an edit, a pass or a take.
int addTo(const PathArguments& arguments, CommandContext& context) {
    if (arguments.take != 0) return changeTakes(arguments, true, context);
    if (arguments.pass.kind.empty() && arguments.edit.empty())
        return context.fail({ErrorCode::argumentInvalid, "--edit", "",
                             worded(BURIN_TEXT("Command", "an edit, a pass with --pass, or a take with --take"))});
    if (arguments.pass.kind.empty())
        return change(arguments, context, [&](StoredPath& path) { return applyEdit(path, arguments); });
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> path = pathWithId(**project, arguments.path);
    if (!path) return context.fail(path.error());
    return addPassTo(*project, *path, arguments.pass, arguments.machine, context);
}

int remove(const PathArguments& arguments, CommandContext& context) {
    if (arguments.take != 0) return changeTakes(arguments, false, context);
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> path = pathWithId(**project, arguments.path);
    return path ? removeFrom(*project, *path, arguments.meantPass, context) : context.fail(path.error());
}

int import(const PathArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    return project ? addProgramPaths(*project, arguments.program, arguments.machine, context)
                   : context.fail(project.error());
}

int computeAgain(const PathArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> path = pathWithId(**project, arguments.path);
    if (!path) return context.fail(path.error());
    return recompute(*project, *path, {arguments.meantPass, arguments.outdatedOnly}, arguments.machine, context);
}

Result<void> checkPosition(const StoredPath& path, const PathArguments& arguments) {
    if (arguments.place < path.edits.size()) return {};
    return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                 worded(BURIN_TEXT("Command", "0 to %1 (exclusive)"), {std::to_string(path.edits.size())})};
}

Result<void> removeEdit(StoredPath& path, const PathArguments& arguments) {
    if (const Result<void> there = checkPosition(path, arguments); !there) return there;
    path.edits.erase(path.edits.begin() + static_cast<std::ptrdiff_t>(arguments.place));
    return {};
}

Result<void> movePass(StoredPath& path, const PathArguments& arguments) {
    Result<std::vector<PathSource>> moved =
        movedSource(path.sources, {arguments.meantPass.value_or(0)}, arguments.place);
    if (!moved) return std::move(moved).error();
    path.sources = std::move(*moved);
    return {};
}

Result<void> updateEdit(StoredPath& path, const PathArguments& arguments) {
    if (const Result<void> there = checkPosition(path, arguments); !there) return there;
    const std::optional<Edit> newer = updated(path.edits[arguments.place]);
    if (!newer)
        return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                     worded(BURIN_TEXT("Command", "an edit of an earlier version; this one is current"))};
    path.edits[arguments.place] = *newer;
    return {};
}

/// Errors: those of checkOutput.
Result<void> checkPlace(const PathArguments& arguments) {
    const std::array<std::filesystem::path, 1> inputs{arguments.project};
    return arguments.output.empty() ? Result<void>() : checkOutput(arguments.outputOption, arguments.output, inputs);
}

/// Evaluates a path, reports its edits and, with an output, writes its points.
int show(const PathArguments& arguments, CommandContext& context) {
    if (const Result<void> free = checkPlace(arguments); !free) return context.fail(free.error());
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> stored = pathWithId(*project, arguments.path);
    if (!stored) return context.fail(stored.error());
    const Result<std::vector<SourceInfo>> sources = sourcesOf(*project);
    if (!sources) return context.fail(sources.error());
    const Result<Tool> tool = toolFor(*project, toolOf(*stored, *sources));
    if (!tool) return context.fail(tool.error());
    const Result<MillingContext> milling =
        makeMillingContext(*project, *tool, machineFor(*project, arguments.machine, context), context.progress());
    if (!milling) return context.fail(milling.error());
    context.stage(BURIN_TEXT("Command", "Editing"));
    const Result<EvaluatedPath> path = evaluateInJob(*project, *milling, *stored, context.progress());
    if (!path) return context.fail(path.error());
    const Result<std::vector<GeneratedInfo>> passes = passesOf(*project, *stored);
    if (!passes) return context.fail(passes.error());
    json answer = jsonOf(*stored, *passes);
    const Result<FigureMatter> matter = figureMatter(*project, *path);
    if (!matter) return context.fail(matter.error());
    const Result<std::vector<PassFigures>> figures = passFigures(*matter, *milling, *stored, *path, context.progress());
    if (!figures) return context.fail(figures.error());
    addFigures(*figures, answer["passes"]);
    KeptLeads leads;
    const Result<std::vector<std::int64_t>> outdated = outdatedPassesOf(*project, *stored, *milling, leads, context);
    if (!outdated) return context.fail(outdated.error());
    addOutdated(*outdated, answer["passes"]);
    answer["reports"] = burin::jsonOf(path->reports);
    answer["points"] = path->path.points.size();
    answer["error_budget_mm"] = path->errorBudget;
    const auto bySide = lengthsBySide(path->path, path->sides);
    const double climb = bySide[static_cast<std::size_t>(MillingSide::climb)],
                 conventional = bySide[static_cast<std::size_t>(MillingSide::conventional)];
    answer["climb_mm"] = climb;
    answer["conventional_mm"] = conventional;
    std::string text = textOf(*stored, *passes) + textOf(*figures) + textOfOutdated(*outdated) + "\n" +
                       worded(BURIN_TEXT("Command", "%1 points, error budget %2 mm, climb %3 mm, conventional %4 mm"),
                              {std::to_string(path->path.points.size()), formatFixed(path->errorBudget, 4),
                               formatFixed(climb, 1), formatFixed(conventional, 1)});
    for (const EditReport& report : path->reports)
        text += "\n  " + worded(BURIN_TEXT("Command", "%1: %2 -> %3 points, at most %4 mm"),
                                {report.edit, std::to_string(report.pointsBefore), std::to_string(report.pointsAfter),
                                 formatFixed(report.largestDeviation, 4)});
    text += textOfEntries(path->reports) + textOfOmissions(path->reports);
    if (!arguments.output.empty()) {
        if (const Result<void> written = writeFileAtomically(arguments.output, csvOf(path->path)); !written)
            return context.fail(written.error());
        answer["csv"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    }
    context.answer(answer, text);
    return 0;
}

/// The materials that a take milled; if it does not state them (before format 4), those of the project's workpiece;
/// empty if that can no longer be made.
MaterialIds materialIdsOf(const Project& project, const TakeInfo& take) {
    if (!take.materials.empty()) return take.materials;
    const Result<Model> model = project.model();
    const Result<Setup> setup = project.setup();
    const Result<std::vector<Property>> materials = project.materials();
    if (!model || !setup || !materials) return {};
    const Result<PropertyList> list = propertyListOf(*model, *setup, *materials);
    return list ? idsOf(*list) : MaterialIds{};
}

/// Writes a take as CSV: complete, or only the stylus, as a trace that `burin mill` can play.
int exportTake(const PathArguments& arguments, bool asTrace, CommandContext& context) {
    if (const Result<void> free = checkPlace(arguments); !free) return context.fail(free.error());
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<TakeOutline> take = project->takeOutline(arguments.take);
    if (!take) return context.fail(take.error());
    const SampleSource source = [&](const SampleVisitor& visit) {
        return project->visitSamples(arguments.take, visit);
    };
    const Result<void> written = asTrace ? writeTakeTrace(arguments.output, *take, source)
                                         : writeTakeCsv(arguments.output, source, materialIdsOf(*project, take->info));
    if (!written) return context.fail(written.error());
    const std::uint64_t samples = take->info.sampleCount;
    context.answer(
        {{"csv", std::filesystem::absolute(arguments.output).lexically_normal().string()}, {"samples", samples}},
        worded(BURIN_TEXT("Command", "%1: %2 samples"), {arguments.output, std::to_string(samples)}));
    return 0;
}

} // namespace

void registerPath(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<PathArguments>();
    const CommandParser command = program.command("path", BURIN_TEXT("Help", "List, make, edit and export paths"));
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command.allowOneCommand();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    const auto add = [&](const char* name, TextId help, auto action) {
        const CommandParser part = command.command(name, help);
        addSetupChoice(part, context);
        addJsonFlag(part, context);
        part.run([arguments, action, &context, &status] { status = action(*arguments, context); });
        return part;
    };
    const auto withPath = [&](CommandParser part) {
        part.positional(BURIN_TEXT("Argument", "PATH"), arguments->path, BURIN_TEXT("Help", "Number of the path"))
            .required();
        return part;
    };
    command.run([command, arguments, &context, &status] {
        if (!command.commandGiven()) status = list(*arguments, context);
    });
    add("list", BURIN_TEXT("Help", "List the paths and their edits"), list);
    const CommandParser make =
        add("new", BURIN_TEXT("Help", "Make a path from takes or of a computed pass, with the standard edits"), create);
    const Argument pass = addPass(make, arguments->pass);
    make.option("--takes", arguments->takes,
                BURIN_TEXT("Help", "Takes in order, all of one tool (default: all takes of the last tool that milled)"))
        .separatedBy(',')
        .excludes(pass);
    make.option("--name", arguments->name,
                BURIN_TEXT("Help", "Name of the path (default: \"path\", or what the pass is)"));
    make.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    const CommandParser foreign = add(
        "import", BURIN_TEXT("Help", "Make paths of a program of another system (G-code or APT/CL), one for each tool"),
        import);
    foreign
        .positional(BURIN_TEXT("Argument", "PROGRAM"), arguments->program.file, BURIN_TEXT("Help", "Program to read"))
        .required();
    foreign.option("--tool", arguments->program.tool,
                   BURIN_TEXT("Help", "Tool of the whole program (default: the project's tools by their numbers)"));
    foreign.option("--dialect", arguments->program.dialect,
                   BURIN_TEXT("Help", "Dialect of the program (default: the project's, or the machine's)"));
    foreign.option("--name", arguments->program.name,
                   BURIN_TEXT("Help", "Name of the path (default: the program's file)"));
    foreign.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    const CommandParser evaluateOne =
        withPath(add("show", BURIN_TEXT("Help", "Evaluate a path and report what each edit did"), show));
    const Argument output =
        evaluateOne.option("-o,--output", arguments->output, BURIN_TEXT("Help", "Write the points as CSV"));
    evaluateOne
        .option(
            "--csv",
            [arguments](const std::string& file) {
                arguments->output = file;
                arguments->outputOption = "--csv";
            },
            BURIN_TEXT("Help", "The same as --output"))
        .excludes(output);
    evaluateOne.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    const CommandParser further =
        withPath(add("apply", BURIN_TEXT("Help", "Add an edit, a computed pass or a take to a path"), addTo));
    const Argument furtherPass = addPass(further, arguments->pass);
    const Argument edit =
        further
            .option("--edit", arguments->edit,
                    BURIN_TEXT("Help", "The edit as JSON, as \"burin path P list --json\" shows them"))
            .excludes(furtherPass);
    further
        .option("--take", arguments->take,
                BURIN_TEXT("Help", "Take to mill last in the path; copies of takes are added to a path only this way"))
        .excludes(furtherPass)
        .excludes(edit);
    further.option("--place", arguments->place, BURIN_TEXT("Help", "Position in the list of edits, from 0"))
        .needs(edit);
    further.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    const CommandParser erase = withPath(add("delete",
                                             BURIN_TEXT("Help", "Delete a path with its computed passes, or remove one "
                                                                "pass or one take from it; takes stay in the project"),
                                             remove));
    const CommandParser again = withPath(add(
        "recompute", BURIN_TEXT("Help", "Compute the passes of a path again, as each was asked for"), computeAgain));
    again.flag("--outdated", arguments->outdatedOnly,
               BURIN_TEXT("Help", "Only the passes whose strokes (--lead, --hand) have changed since they were "
                                  "computed, as \"path P show\" reports them"));
    again.option("--machine", arguments->machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
    const CommandParser order =
        withPath(add("order", BURIN_TEXT("Help", "Move a pass or take to another position in its path"),
                     [](const PathArguments& given, CommandContext& where) {
                         return change(given, where, [&](StoredPath& path) { return movePass(path, given); });
                     }));
    order.option("--place", arguments->place, BURIN_TEXT("Help", "Position, from 0: the first is milled first"))
        .required();
    erase.option("--take", arguments->take, BURIN_TEXT("Help", "Take to remove from the path"));
    for (const CommandParser& one : {erase, again, order})
        one.option(
            "--pass",
            [arguments](const std::string& id) {
                arguments->meantPass = parseNumber(id) ? static_cast<std::int64_t>(*parseNumber(id)) : 0;
            },
            BURIN_TEXT("Help", "Id of the pass, as \"path P list --json\" shows it"));
    further
        .option(
            "--instead",
            [arguments](const std::string& id) {
                arguments->pass.instead = parseNumber(id) ? static_cast<std::int64_t>(*parseNumber(id)) : 0;
            },
            BURIN_TEXT("Help", "Compute it in place of the pass with this id"))
        .needs(furtherPass);
    const CommandParser undo =
        withPath(add("undo", BURIN_TEXT("Help", "Delete an edit from a path"),
                     [](const PathArguments& given, CommandContext& where) {
                         return change(given, where, [&](StoredPath& path) { return removeEdit(path, given); });
                     }));
    undo.option("--place", arguments->place, BURIN_TEXT("Help", "Position of the edit in the list, from 0")).required();
    const CommandParser update =
        withPath(add("update", BURIN_TEXT("Help", "Bring an edit of an earlier version up to date"),
                     [](const PathArguments& given, CommandContext& where) {
                         return change(given, where, [&](StoredPath& path) { return updateEdit(path, given); });
                     }));
    update.option("--place", arguments->place, BURIN_TEXT("Help", "Position of the edit in the list, from 0"))
        .required();
    addCompare(
        withPath(add("compare", BURIN_TEXT("Help", "Compare a path with another one, or with a version of itself"),
                     [](const PathArguments& given, CommandContext& where) {
                         return comparePathsOf(given.project, given.path, given.compare, given.machine, where);
                     })),
        arguments->compare, arguments->machine);
    for (const bool asTrace : {false, true}) {
        const CommandParser part = add(
            asTrace ? "trace" : "take",
            asTrace ? BURIN_TEXT("Help", "Write the stylus motion of a take as a trace that \"burin mill\" replays")
                    : BURIN_TEXT("Help", "Write a take as CSV"),
            [asTrace](const PathArguments& given, CommandContext& where) { return exportTake(given, asTrace, where); });
        part.positional(BURIN_TEXT("Argument", "TAKE"), arguments->take, BURIN_TEXT("Help", "Number of the take"))
            .required();
        part.option("-o,--output", arguments->output, BURIN_TEXT("Help", "File to write")).required();
    }
}

} // namespace burin
