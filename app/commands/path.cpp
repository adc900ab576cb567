// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/job/job_paths.h"
#include "core/path/milling_side.h"
#include "core/recording/take_csv.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <sstream>

namespace burin {

namespace {

using nlohmann::json;

struct PathArguments {
    std::string project, machine, output, edit, name = "path";
    std::string outputOption = "--output"; ///< that the user gave the output with
    std::int64_t path = 0, take = 0;
    std::vector<std::int64_t> takes;
    std::size_t place = 0;
};

json jsonOf(const StoredPath& path) {
    json edits = json::array();
    for (const Edit& edit : path.edits) edits.push_back(json::parse(toJson(edit)));
    return {{"id", path.id}, {"name", path.name}, {"takes", path.takes}, {"edits", edits}};
}

std::string textOf(const StoredPath& path) {
    std::ostringstream text;
    text << "path " << path.id << " " << path.name << ", takes";
    for (const std::int64_t take : path.takes) text << " " << take;
    for (std::size_t i = 0; i < path.edits.size(); ++i) text << "\n  " << i << "  " << toJson(path.edits[i]);
    return text.str();
}

Result<StoredPath> pathWithId(const Project& project, std::int64_t id) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    std::string known;
    for (const StoredPath& path : *paths) {
        if (path.id == id) return path;
        known += (known.empty() ? "" : ", ") + std::to_string(path.id);
    }
    return Error{ErrorCode::nameUnknown, "path", std::to_string(id), known};
}

int list(const PathArguments& arguments, CommandContext& context) {
    const Result<Project> project = Project::openForReading(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<std::vector<StoredPath>> paths = project->paths();
    if (!paths) return context.fail(paths.error());
    json answer{{"paths", json::array()}};
    std::string text = paths->empty() ? "no paths" : "";
    for (const StoredPath& path : *paths) {
        answer["paths"].push_back(jsonOf(path));
        text += (text.empty() ? "" : "\n") + textOf(path);
    }
    context.answer(answer, text);
    return 0;
}

/// A path has one tool: that of the first take asked for, or the last one that milled.
Result<std::string> toolForNew(const Project& project, const PathArguments& arguments) {
    if (arguments.takes.empty()) {
        const Result<std::vector<TakeInfo>> standing = standingTakes(project);
        if (!standing) return standing.error();
        return standing->empty() ? std::string() : standing->back().toolId;
    }
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const auto first = std::ranges::find(*takes, arguments.takes.front(), &TakeInfo::id);
    if (first == takes->end())
        return Error{ErrorCode::nameUnknown, "take", std::to_string(arguments.takes.front()), {}};
    return first->toolId;
}

int create(const PathArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = ProjectChange::open(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<std::string> tool = toolForNew(**project, arguments);
    if (!tool) return context.fail(tool.error());
    Result<StoredPath> path = standardPath(**project, *tool);
    if (!path) return context.fail(path.error());
    path->name = arguments.name;
    for (const std::int64_t take : arguments.takes)
        if (std::ranges::find(path->takes, take) == path->takes.end())
            return context.fail({ErrorCode::argumentInvalid, "--takes", std::to_string(take),
                                 "recordings made with " + *tool + ", as the first one"});
    if (!arguments.takes.empty()) path->takes = arguments.takes;
    const Result<std::int64_t> id = (*project)->addPath(*path);
    if (!id) return context.fail(id.error());
    path->id = *id;
    if (const Result<void> saved = project->save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, **project);
    context.answer(jsonOf(*path), textOf(*path));
    return 0;
}

/// Changes the edits of one path and saves.
int change(const PathArguments& arguments, CommandContext& context,
           const std::function<Result<void>(StoredPath&)>& changeEdits) {
    Result<ProjectChange> project = ProjectChange::open(arguments.project);
    if (!project) return context.fail(project.error());
    Result<StoredPath> path = pathWithId(**project, arguments.path);
    if (!path) return context.fail(path.error());
    if (const Result<void> changed = changeEdits(*path); !changed) return context.fail(changed.error());
    if (const Result<void> stored = (*project)->setPath(*path); !stored) return context.fail(stored.error());
    if (const Result<void> saved = project->save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, **project);
    context.answer(jsonOf(*path), textOf(*path));
    return 0;
}

Result<void> applyEdit(StoredPath& path, const PathArguments& arguments) {
    const Result<Edit> edit = editFromJson(arguments.edit);
    if (!edit) return edit.error();
    if (arguments.place > path.edits.size())
        return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                     "0 to " + std::to_string(path.edits.size())};
    path.edits.insert(path.edits.begin() + static_cast<std::ptrdiff_t>(arguments.place), *edit);
    return {};
}

Result<void> checkPosition(const StoredPath& path, const PathArguments& arguments) {
    if (arguments.place < path.edits.size()) return {};
    return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                 "0 to " + std::to_string(path.edits.size()) + " (exclusive)"};
}

Result<void> removeEdit(StoredPath& path, const PathArguments& arguments) {
    if (const Result<void> there = checkPosition(path, arguments); !there) return there;
    path.edits.erase(path.edits.begin() + static_cast<std::ptrdiff_t>(arguments.place));
    return {};
}

Result<void> updateEdit(StoredPath& path, const PathArguments& arguments) {
    if (const Result<void> there = checkPosition(path, arguments); !there) return there;
    const std::optional<Edit> newer = updated(path.edits[arguments.place]);
    if (!newer)
        return Error{ErrorCode::argumentInvalid, "--place", std::to_string(arguments.place),
                     "an edit of an earlier version; this one is current"};
    path.edits[arguments.place] = *newer;
    return {};
}

/// Empty for a straight move.
std::string arcColumns(const PathPoint& point) {
    if (!point.arc) return ",,,,,";
    std::string text;
    for (int axis = 0; axis < 3; ++axis) text += "," + formatShortest(point.arc->centre[axis]);
    constexpr const char* letters[] = {"x", "y", "z"};
    return text + "," + letters[point.arc->axis] + (point.arc->clockwise ? ",1" : ",0");
}

std::string csvOf(const Path& path) {
    constexpr const char* kinds[] = {"rapid", "plunge", "cut", "retract"};
    std::string text = "kind,x_mm,y_mm,z_mm,feed_mm_min,take,sample,"
                       "arc_centre_x_mm,arc_centre_y_mm,arc_centre_z_mm,arc_axis,arc_clockwise\n";
    for (const PathPoint& point : path.points) {
        text += kinds[static_cast<std::size_t>(point.kind)];
        for (int axis = 0; axis < 3; ++axis) text += "," + formatShortest(point.tip[axis]);
        text += "," + formatShortest(point.feed) + "," + std::to_string(point.take) + "," +
                std::to_string(point.sample) + arcColumns(point) + "\n";
    }
    return text;
}

/// Errors: those of checkOutput.
Result<void> checkPlace(const PathArguments& arguments) {
    const std::array<std::filesystem::path, 1> inputs{arguments.project};
    return arguments.output.empty() ? Result<void>() : checkOutput(arguments.outputOption, arguments.output, inputs);
}

/// Evaluates a path, reports its edits and, with an output, writes its points.
int show(const PathArguments& arguments, CommandContext& context) {
    if (const Result<void> free = checkPlace(arguments); !free) return context.fail(free.error());
    context.stage("Opening");
    const Result<Project> project = Project::openForReading(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> stored = pathWithId(*project, arguments.path);
    if (!stored) return context.fail(stored.error());
    const Result<std::vector<TakeInfo>> takes = project->takes();
    if (!takes) return context.fail(takes.error());
    const Result<Tool> tool = toolFor(*project, toolOf(*stored, *takes));
    if (!tool) return context.fail(tool.error());
    const Result<Bench> bench =
        makeBench(*project, *tool, machineFor(*project, arguments.machine, context), context.progress());
    if (!bench) return context.fail(bench.error());
    context.stage("Editing");
    const Result<EvaluatedPath> path = evaluateInJob(*project, *bench, *stored, context.progress());
    if (!path) return context.fail(path.error());
    json answer = jsonOf(*stored);
    answer["reports"] = burin::jsonOf(path->reports);
    answer["points"] = path->path.points.size();
    answer["error_budget_mm"] = path->errorBudget;
    const auto bySide = lengthsBySide(path->path, path->sides);
    const double climb = bySide[static_cast<std::size_t>(MillingSide::climb)],
                 conventional = bySide[static_cast<std::size_t>(MillingSide::conventional)];
    answer["climb_mm"] = climb;
    answer["conventional_mm"] = conventional;
    std::string text = textOf(*stored) + "\n" + std::to_string(path->path.points.size()) + " points, error budget " +
                       formatFixed(path->errorBudget, 4) + " mm, climb " + formatFixed(climb, 1) +
                       " mm, conventional " + formatFixed(conventional, 1) + " mm";
    for (const EditReport& report : path->reports)
        text += "\n  " + report.edit + ": " + std::to_string(report.pointsBefore) + " -> " +
                std::to_string(report.pointsAfter) + " points, at most " + formatFixed(report.largestDeviation, 4) +
                " mm";
    text += textOfEntries(path->reports) + textOfOmissions(path->reports);
    if (!arguments.output.empty()) {
        if (const Result<void> written = writeFileAtomically(arguments.output, csvOf(path->path)); !written)
            return context.fail(written.error());
        answer["csv"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    }
    context.answer(answer, text);
    return 0;
}

/// Writes a take as CSV: all that was recorded, or the stylus alone as a trace that `burin mill` plays.
int exportTake(const PathArguments& arguments, bool asTrace, CommandContext& context) {
    if (const Result<void> free = checkPlace(arguments); !free) return context.fail(free.error());
    const Result<Project> project = Project::openForReading(arguments.project);
    if (!project) return context.fail(project.error());
    const Result<TakeOutline> take = project->takeOutline(arguments.take);
    if (!take) return context.fail(take.error());
    const SampleSource source = [&](const SampleVisitor& visit) {
        return project->visitSamples(arguments.take, visit);
    };
    const Result<void> written =
        asTrace ? writeTakeTrace(arguments.output, source) : writeTakeCsv(arguments.output, source);
    if (!written) return context.fail(written.error());
    const std::uint64_t samples = take->info.sampleCount;
    context.answer(
        {{"csv", std::filesystem::absolute(arguments.output).lexically_normal().string()}, {"samples", samples}},
        arguments.output + ": " + std::to_string(samples) + " samples");
    return 0;
}

} // namespace

void registerPath(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<PathArguments>();
    CLI::App* command = program.add_subcommand("path", "List, make, edit and export paths");
    command->add_option("PROJECT", arguments->project, "Project file (.burin)")->required();
    command->require_subcommand(0, 1);
    addJsonFlag(*command, context);
    const auto add = [&](const char* name, const char* help, auto action) {
        CLI::App* part = command->add_subcommand(name, help);
        addJsonFlag(*part, context);
        part->callback([arguments, action, &context, &status] { status = action(*arguments, context); });
        return part;
    };
    const auto withPath = [&](CLI::App* part) {
        part->add_option("PATH", arguments->path, "Number of the path")->required();
        return part;
    };
    command->callback([command, arguments, &context, &status] {
        if (command->get_subcommands().empty()) status = list(*arguments, context);
    });
    add("list", "The paths and their edits", list);
    CLI::App* make = add("new", "Make a path from takes, with the standard edits", create);
    make->add_option("--takes", arguments->takes,
                     "Takes in order, of one tool; without it all takes of the last tool that milled")
        ->delimiter(',');
    make->add_option("--name", arguments->name, "Its name")->capture_default_str();
    CLI::App* evaluateOne = withPath(add("show", "Evaluate a path and report what each edit did", show));
    CLI::Option* output = evaluateOne->add_option("-o,--output", arguments->output, "Write the points as CSV");
    evaluateOne
        ->add_option_function<std::string>(
            "--csv",
            [arguments](const std::string& file) {
                arguments->output = file;
                arguments->outputOption = "--csv";
            },
            "The same as --output")
        ->excludes(output);
    evaluateOne->add_option("--machine", arguments->machine, "Machine; without it the project's");
    CLI::App* apply =
        withPath(add("apply", "Add an edit to a path", [](const PathArguments& given, CommandContext& where) {
            return change(given, where, [&](StoredPath& path) { return applyEdit(path, given); });
        }));
    apply->add_option("--edit", arguments->edit, "The edit as JSON, as \"burin path P list --json\" shows them")
        ->required();
    apply->add_option("--place", arguments->place, "Position in the list of edits, from 0")->required();
    CLI::App* undo =
        withPath(add("undo", "Delete an edit from a path", [](const PathArguments& given, CommandContext& where) {
            return change(given, where, [&](StoredPath& path) { return removeEdit(path, given); });
        }));
    undo->add_option("--place", arguments->place, "Position of the edit in the list, from 0")->required();
    CLI::App* update =
        withPath(add("update", "Bring an edit of an earlier version up to date",
                     [](const PathArguments& given, CommandContext& where) {
                         return change(given, where, [&](StoredPath& path) { return updateEdit(path, given); });
                     }));
    update->add_option("--place", arguments->place, "Position of the edit in the list, from 0")->required();
    for (const bool asTrace : {false, true}) {
        CLI::App* part = add(
            asTrace ? "trace" : "take",
            asTrace ? "Write the stylus motion of a take as a trace that \"burin mill\" replays"
                    : "Write a take as CSV",
            [asTrace](const PathArguments& given, CommandContext& where) { return exportTake(given, asTrace, where); });
        part->add_option("TAKE", arguments->take, "Number of the take")->required();
        part->add_option("-o,--output", arguments->output, "File to write")->required();
    }
}

} // namespace burin
