// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/path_compare.h"

#include "app/chosen_setup.h"
#include "app/path_report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/job_paths.h"

#include <array>
#include <cmath>

namespace burin {

namespace {

using nlohmann::json;

/// The version of a path that is compared.
struct ComparedVersion {
    StoredPath path;
    std::string about; ///< describes the version, for people
    json variation;    ///< null: the unchanged path
};

/// Describes the valid positions of an edit.
std::string positionsOf(const StoredPath& path) {
    if (path.edits.empty()) return worded(BURIN_TEXT("Command", "the path has no edits"));
    return worded(BURIN_TEXT("Command", "0 to %1"), {std::to_string(path.edits.size() - 1)});
}

/// Errors: argumentInvalid (no such edit).
Result<ComparedVersion> withoutEdit(StoredPath path, const std::string& position) {
    const std::optional<double> number = parseNumber(position);
    if (!number || !(*number >= 0.0) || *number != std::floor(*number) ||
        !(*number < static_cast<double>(path.edits.size())))
        return Error{ErrorCode::argumentInvalid, "--without", position, positionsOf(path)};
    const auto edit = path.edits.begin() + static_cast<std::ptrdiff_t>(*number);
    const std::string id(idOf(edit->parameters));
    path.edits.erase(edit);
    return ComparedVersion{std::move(path),
                           worded(BURIN_TEXT("Command", "without edit %1 (%2)"), {formatFixed(*number, 0), id}),
                           {{"without", static_cast<std::size_t>(*number)}, {"edit", id}}};
}

/// Errors: argumentInvalid (not exactly one of the three options is given), those of pathWithId.
Result<ComparedVersion> otherVersion(const Project& project, const StoredPath& first,
                                     const CompareArguments& arguments) {
    const int ways = (arguments.second != 0 ? 1 : 0) + (arguments.without ? 1 : 0) + (arguments.recorded ? 1 : 0);
    if (ways != 1)
        return Error{ErrorCode::argumentInvalid, "compare", "",
                     worded(BURIN_TEXT("Command", "a second path, --without or --recorded"))};
    if (arguments.without) return withoutEdit(first, *arguments.without);
    if (arguments.recorded) {
        ComparedVersion version{first, worded(BURIN_TEXT("Command", "without edits")), {{"recorded", true}}};
        version.path.edits.clear();
        return version;
    }
    Result<StoredPath> second = pathWithId(project, arguments.second);
    if (!second) return std::move(second).error();
    return ComparedVersion{std::move(*second), {}, {}};
}

json jsonOf(const PathTotals& totals, const std::optional<PathDeviation>& deviation) {
    json answer{{"cutting_mm", totals.cutting}, {"plunge_mm", totals.plunging},
                {"air_mm", totals.air},         {"points", totals.points},
                {"arcs", totals.arcs},          {"time_at_feed_s", totals.feedTime ? json(*totals.feedTime) : json()},
                {"deviation", json()}};
    if (deviation)
        answer["deviation"] = {
            {"largest_mm", deviation->largest},
            {"largest_at_mm", {deviation->largestAt.x, deviation->largestAt.y, deviation->largestAt.z}},
            {"mean_mm", deviation->mean},
            {"farther_mm", deviation->farther},
            {"farther_share", deviation->fartherShare()},
            {"farther_parts", deviation->fartherParts.size()}};
    return answer;
}

/// A value of both paths, and the difference of the second to the first.
std::string rowOf(TextId title, double first, double second, int decimals, const char* unit) {
    const double difference = second - first;
    return "\n  " + worded(title) + ": " +
           worded(BURIN_TEXT("Command", "%1 and %2 (%3)"),
                  {formatFixed(first, decimals) + unit, formatFixed(second, decimals) + unit,
                   (difference > 0.0 ? "+" : "") + formatFixed(difference, decimals) + unit});
}

std::string textOf(TextId title, const PathDeviation& deviation) {
    std::string place;
    for (int axis = 0; axis < 3; ++axis) place += (axis > 0 ? ", " : "") + formatFixed(deviation.largestAt[axis], 3);
    return "\n  " + worded(title) + ": " +
           worded(BURIN_TEXT("Command", "at most %1 mm at (%2) mm, mean %3 mm; %4 % of its cuts (%5 mm) are farther"),
                  {formatFixed(deviation.largest, 4), place, formatFixed(deviation.mean, 4),
                   formatFixed(100.0 * deviation.fartherShare(), 1), formatFixed(deviation.farther, 1)});
}

std::string textOf(const PathDifference& comparison) {
    const PathTotals &a = comparison.first, &b = comparison.second;
    std::string text = rowOf(BURIN_TEXT("Command", "Cuts"), a.cutting, b.cutting, 1, " mm") +
                       rowOf(BURIN_TEXT("Command", "Plunges"), a.plunging, b.plunging, 1, " mm") +
                       rowOf(BURIN_TEXT("Command", "Rapids and retracts"), a.air, b.air, 1, " mm");
    const auto count = [](std::size_t number) { return static_cast<double>(number); };
    text += rowOf(BURIN_TEXT("Command", "Points"), count(a.points), count(b.points), 0, "");
    text += rowOf(BURIN_TEXT("Command", "Arcs"), count(a.arcs), count(b.arcs), 0, "");
    if (a.feedTime && b.feedTime)
        text += rowOf(BURIN_TEXT("Command", "Time at feed"), *a.feedTime, *b.feedTime, 1, " s");
    else
        text += "\n  " + worded(BURIN_TEXT("Command", "Time at feed: unknown, as a path has moves without a feed"));
    if (!comparison.ofFirst || !comparison.ofSecond)
        return text + "\n  " + worded(BURIN_TEXT("Command", "No deviation: one of the paths has no cuts"));
    return text + textOf(BURIN_TEXT("Command", "First from second"), *comparison.ofFirst) +
           textOf(BURIN_TEXT("Command", "Second from first"), *comparison.ofSecond);
}

/// Errors: those of sourcesOf, toolFor, makeMillingContext, evaluateInJob and differenceOf.
Result<PathDifference> compared(const Project& project, const StoredPath& first, const StoredPath& second,
                                double tolerance, const std::string& machine, CommandContext& context) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const Result<Tool> tool = toolFor(project, toolOf(first, *sources));
    if (!tool) return tool.error();
    const Result<MillingContext> milling =
        makeMillingContext(project, *tool, machineFor(project, machine, context), context.progress());
    if (!milling) return milling.error();
    context.stage(BURIN_TEXT("Command", "Editing"));
    std::array<Path, 2> paths;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Result<EvaluatedPath> evaluated = evaluateInJob(project, *milling, i == 0 ? first : second, context.progress());
        if (!evaluated) return std::move(evaluated).error();
        paths[i] = std::move(evaluated->path);
    }
    context.stage(BURIN_TEXT("Command", "Comparing"));
    return differenceOf(paths[0], paths[1], tolerance, context.progress());
}

} // namespace

void addCompare(CommandParser part, CompareArguments& compare, std::string& machine) {
    const Argument second = part.positional(BURIN_TEXT("Argument", "OTHER"), compare.second,
                                            BURIN_TEXT("Help", "Number of the path to compare with"));
    const Argument without =
        part.option("--without", compare.without,
                    BURIN_TEXT("Help", "Compare with the path without this edit: its position in the list, from 0"))
            .excludes(second);
    part.flag("--recorded", compare.recorded,
              BURIN_TEXT("Help", "Compare with the path without its edits, as it was recorded or computed"))
        .excludes(second)
        .excludes(without);
    part.option("--tolerance", compare.tolerance,
                BURIN_TEXT("Help", "Distance in mm beyond which parts of the paths count as different"))
        .range(comparedTolerances.low, comparedTolerances.high)
        .showDefault();
    part.option("--machine", machine, BURIN_TEXT("Help", "Machine (default: the project's)"));
}

int comparePathsOf(const std::string& file, std::int64_t number, const CompareArguments& arguments,
                   const std::string& machine, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(file, context);
    if (!project) return context.fail(project.error());
    const Result<StoredPath> first = pathWithId(*project, number);
    if (!first) return context.fail(first.error());
    const Result<ComparedVersion> second = otherVersion(*project, *first, arguments);
    if (!second) return context.fail(second.error());
    const Result<PathDifference> comparison =
        compared(*project, *first, second->path, arguments.tolerance, machine, context);
    if (!comparison) return context.fail(comparison.error());
    json answer{{"tolerance_mm", comparison->tolerance},
                {"first", jsonOf(comparison->first, comparison->ofFirst)},
                {"second", jsonOf(comparison->second, comparison->ofSecond)}};
    answer["first"].update({{"id", first->id}, {"name", first->name}});
    answer["second"].update({{"id", second->path.id}, {"name", second->path.name}, {"variation", second->variation}});
    const auto named = [](const StoredPath& path, const std::string& about) {
        return worded(BURIN_TEXT("Command", "path %1 %2"), {std::to_string(path.id), path.name}) +
               (about.empty() ? "" : " " + about);
    };
    const std::string title =
        worded(BURIN_TEXT("Command", "%1 and %2, tolerance %3 mm"),
               {named(*first, {}), named(second->path, second->about), formatShortest(comparison->tolerance)});
    context.answer(answer, title + textOf(*comparison));
    return 0;
}

} // namespace burin
