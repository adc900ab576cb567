// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/evaluate.h"

#include "core/base/numbers.h"
#include "core/path/apply.h"
#include "core/path/edit_step.h"
#include "core/path/hand_trail.h"
#include "core/path/kept_edits.h"
#include "core/path/polyline.h"
#include "core/path/stated_feeds.h"
#include "core/path/stroke.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {
namespace {

constexpr double drawnTolerance = 0.01; // mm: less than a picture shows

Result<EditReport> applyOne(const Edit& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    EditReport report;
    report.edit = idOf(edit.parameters);
    report.pointsBefore = state.count();
    const Result<Deviation> deviation = std::visit(
        [&](const auto& parameters) { return apply(parameters, state, context, progress); }, edit.parameters);
    if (!deviation) return deviation.error();
    report.pointsAfter = state.count();
    report.largestDeviation = deviation->distance;
    report.worstPlace = deviation->place;
    report.omissions = std::exchange(state.omissions, {});
    report.entries = std::exchange(state.entries, {});
    report.inserted = std::exchange(state.inserted, {});
    report.lengthBefore = std::exchange(state.lengthBefore, 0.0);
    return report;
}

/// The error for a path without remaining points, with its cause.
Error nothingLeft(const std::string& name, const std::vector<EditReport>& reports) {
    const auto last = std::ranges::find_if(reports.rbegin(), reports.rend(),
                                           [](const EditReport& report) { return !report.omissions.empty(); });
    if (last == reports.rend()) return {ErrorCode::pathEmpty, name, "", ""};
    const Omission& part = last->omissions.front();
    const glm::dvec3& place = part.line.front();
    return {ErrorCode::pathGouges, name,
            formatFixed(place.x, 3) + " " + formatFixed(place.y, 3) + " " + formatFixed(place.z, 3) + " mm",
            remedyOf(part.reason).text};
}

Result<EditedState> beforeEdits(std::vector<SourceStrokes> sources, const PathContext& context) {
    EditedState state;
    state.path.hand = std::make_shared<const HandTrail>(sources);
    state.path.stated = std::make_shared<const StatedFeeds>(sources);
    auto axes = std::make_shared<StatedAxes>();
    for (SourceStrokes& each : sources) {
        const SourceInfo& info = each.info;
        if (!info.toolId.empty() && info.toolId != context.tool.id)
            return Error{ErrorCode::argumentInvalid, "tool", info.toolId,
                         nameOf(info.source) + "; the path is for " + context.tool.id};
        if (Result<void> taken = axes->take(each, context.tool); !taken) return std::move(taken).error();
        state.path.allowances[info.source.id] = info.allowance;
        std::ranges::move(each.strokes, std::back_inserter(state.path.strokes));
    }
    if (!axes->empty()) state.path.axes = std::move(axes);
    return state;
}

/// The same line with fewer points: a hand's motion has one every millisecond, far more than a picture shows. Strokes
/// with arcs have few.
std::vector<PathPoint> drawnPointsOf(const PathUnderEdit& path, const Progress& progress) {
    if (path.linked) return pointsOf(path);
    PathUnderEdit drawn;
    for (const PathStroke& stroke : path.strokes) {
        if (std::ranges::any_of(stroke.points, [](const StrokePoint& point) { return point.arc.has_value(); })) {
            drawn.strokes.push_back(stroke);
            continue;
        }
        std::vector<glm::dvec3> tips;
        for (const StrokePoint& point : stroke.points) tips.push_back(point.pose.tip);
        PathStroke& thin = drawn.strokes.emplace_back();
        thin.source = stroke.source;
        for (const std::size_t point : simplifyInGroups(tips, drawnTolerance, progress))
            thin.points.push_back(stroke.points[point]);
    }
    return pointsOf(drawn);
}

EvaluatedPath pathOf(const std::string& name, const EditedState& state, const PathContext& context,
                     std::vector<PathPoint> points) {
    EvaluatedPath evaluated;
    evaluated.reports = state.reports;
    evaluated.errorBudget = state.errorBudget;
    evaluated.path.name = name;
    evaluated.path.toolId = context.tool.id;
    evaluated.path.spindleSpeed = state.path.spindleSpeed;
    evaluated.path.coolant = state.path.coolant;
    evaluated.path.leastFeed = state.path.leastFeed;
    evaluated.path.points = std::move(points);
    return evaluated;
}

} // namespace

Result<EvaluatedPath> evaluate(const std::string& name, const std::vector<Take>& takes, const std::vector<Edit>& edits,
                               const PathContext& context, Progress& progress) {
    std::vector<SourceStrokes> sources;
    for (const Take& take : takes) {
        Result<SourceStrokes> strokes = recordedStrokes(take);
        if (!strokes) return std::move(strokes).error();
        sources.push_back(std::move(*strokes));
    }
    return evaluate(name, std::move(sources), edits, context, progress);
}

Result<EvaluatedPath> evaluate(const std::string& name, std::vector<SourceStrokes> sources,
                               const std::vector<Edit>& edits, const PathContext& context, Progress& progress,
                               const EvaluationHelp& help) {
    if (Result<void> order = checkOrder(edits); !order) return order.error();
    if (!context.tool.cutter.turns())
        for (const Edit& edit : edits)
            if (edit.enabled && !suitsFixedTool(edit.parameters))
                return Error{ErrorCode::argumentInvalid, "edit", std::string(idOf(edit.parameters)),
                             "no feeds, and links at the safe height without ramps: the tool doesn't turn"};
    if (help.kept != nullptr) help.kept->begin(edits, context);
    const std::size_t begin = help.kept != nullptr ? help.kept->count() : 0;
    if (begin == 0 && help.sources != nullptr) sources = *help.sources;
    Result<EditedState> state =
        begin > 0 ? Result<EditedState>(help.kept->newest()) : beforeEdits(std::move(sources), context);
    if (!state) return std::move(state).error();
    bool told = !help.first;
    const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, edits.size()));
    for (std::size_t i = begin; i < edits.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, name, "", ""};
        const ProgressPart part(progress, static_cast<double>(i) * share, static_cast<double>(i + 1) * share);
        if (!edits[i].enabled) continue;
        if (state->path.count() == 0) break;
        Result<EditReport> report = applyOne(edits[i], state->path, context, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, name, "", ""};
        if (!report) return report.error();
        if (traitsOf(edits[i].parameters).approximates) state->errorBudget += report->largestDeviation;
        state->reports.push_back(std::move(*report));
        if (i + 1 == edits.size()) break;
        if (!std::exchange(told, true)) help.first(pathOf(name, *state, context, drawnPointsOf(state->path, progress)));
        if (help.kept != nullptr) help.kept->keep(i + 1, *state);
    }
    EvaluatedPath evaluated = pathOf(name, *state, context, pointsOf(state->path));
    if (evaluated.path.points.empty()) return nothingLeft(name, evaluated.reports);
    progress.report(1.0);
    return evaluated;
}

} // namespace burin
