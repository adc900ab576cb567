// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/axis_course.h"
#include "core/path/axis_guard.h"
#include "core/path/hand_interval.h"
#include "core/path/moves_within.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace burin {
namespace {

constexpr double plumb = 1e-6; // mm sideways: a rapid straight up or down

/// Whether an edit leaves an upright tool as it is.
bool tiltsNothing(const ToolAxis& edit) noexcept {
    if (edit.from == ToolAxis::From::upright) return edit.lead == 0.0 && edit.tilt == 0.0;
    return edit.from == ToolAxis::From::fixed && edit.inclination == 0.0;
}

Result<void> checkTiltable(const ToolAxis& edit, const PathUnderEdit& state, const PathContext& context) {
    if (!state.linked) return Error{ErrorCode::argumentInvalid, "edits", "tool-axis", "link, then tool-axis"};
    if (!context.machine.tilts())
        return Error{ErrorCode::notSupported, "a tilted tool on " + context.machine.name, "a machine with rotary axes",
                     ""};
    if (context.tool.cutter.solid != nullptr || !context.tool.cutter.turns())
        return Error{ErrorCode::notSupported, "tilted tool axis",
                     "tools that turn and are not hollow, unlike " + context.tool.name, ""};
    if (edit.from == ToolAxis::From::program && !state.axes)
        return Error{ErrorCode::argumentInvalid, "tool axis", "the program", "a path of a program that tilts the tool"};
    return {};
}

/// The moves whose axis is set, by the point at which each ends.
std::vector<bool> movesToTilt(const ToolAxis& edit, const PathUnderEdit& state) {
    std::vector<bool> within = movesWithin(state.points, edit.interval);
    for (std::size_t i = 0; i < state.points.size(); ++i) {
        const PathPoint& point = state.points[i];
        const bool stroke =
            point.kind == MoveKind::cut && hasMoment(point) && (i == 0 || hasMoment(state.points[i - 1]));
        if (point.kind == MoveKind::rapid || i == 0 || (edit.ends == ToolAxis::Ends::blend && !stroke))
            within[i] = false;
        if (edit.from == ToolAxis::From::program && hasMoment(point) && !state.axes->holds(point.source))
            within[i] = false;
    }
    return within;
}

/// A path while its axes are set: points before, and those made in their place.
class Tilting {
public:
    Tilting(const std::vector<PathPoint>& points, const ToolAxis& edit, const AxisRules& rules)
        : points_(points), edit_(edit), rules_(rules) {}

    Result<void> run(const std::vector<bool>& within, Progress& progress) {
        for (std::size_t i = 0; i < points_.size();) {
            std::size_t end = i + 1; // the part [i, end) of which all moves but the first are within
            while (end < points_.size() && within[end]) ++end;
            if (end == i + 1) {
                made_.push_back({points_[i], points_[i].pose, false});
                i = end;
                continue;
            }
            if (Result<void> added = addPart(i, end, progress); !added) return added;
            progress.report(0.5 * static_cast<double>(end) / static_cast<double>(points_.size()));
            i = end;
        }
        for (const std::size_t start : starts_) turnBefore(start);
        for (const std::size_t end : ends_) turnBehind(end);
        return {};
    }
    std::vector<TiltedPoint> take() { return std::move(made_); }

private:
    Result<void> addPart(std::size_t first, std::size_t end, const Progress& progress) {
        const bool links = edit_.ends == ToolAxis::Ends::links;
        const bool begins = points_[first].kind == MoveKind::rapid;
        const bool ends = end == points_.size() || points_[end].kind == MoveKind::rapid;
        const Result<std::vector<TiltedPoint>> part = tiltedCourse(
            std::span(points_).subspan(first, end - first), !(links && begins), !(links && ends), rules_, progress);
        if (!part) return part.error();
        if (links && begins) starts_.push_back(made_.size());
        made_.insert(made_.end(), part->begin(), part->end());
        lasts_.insert(made_.size() - 1);
        if (links && ends) ends_.push_back(made_.size() - 1);
        return {};
    }

    // Rapids straight above an end of a part are made with the axis of that end: it turns at the height across.
    void turnBefore(std::size_t start) {
        for (std::size_t i = start;
             i > 0 && made_[i].point.kind == MoveKind::rapid && isPlumb(i - 1, i) && !lasts_.contains(i - 1); --i)
            follow(i - 1, start);
    }
    void turnBehind(std::size_t end) {
        for (std::size_t i = end + 1;
             i < made_.size() && made_[i].point.kind == MoveKind::rapid && isPlumb(i - 1, i) && !made_[i].changed();
             ++i)
            follow(i, end);
    }
    void follow(std::size_t i, std::size_t end) {
        const ToolPose &before = made_[end].before, &pose = made_[end].point.pose;
        made_[i].point.pose = {made_[i].before.tip + (pose.tip - before.tip), pose.axis};
    }
    bool isPlumb(std::size_t a, std::size_t b) const {
        const glm::dvec3 way = made_[b].before.tip - made_[a].before.tip;
        return std::hypot(way.x, way.y) < plumb;
    }

    const std::vector<PathPoint>& points_;
    const ToolAxis& edit_;
    const AxisRules& rules_;
    std::vector<TiltedPoint> made_;
    std::vector<std::size_t> starts_, ends_; ///< first and last points of parts beside a rapid
    std::set<std::size_t> lasts_;            ///< last points of all parts
};

} // namespace

Result<Deviation> apply(const ToolAxis& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    if (tiltsNothing(edit)) return Deviation{};
    if (Result<void> able = checkTiltable(edit, state, context); !able) return std::move(able).error();
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    if (edit.interval.source != 0) state.points = dividedAt(state.points, edit.interval);
    const AxisRules rules{edit, context, *guard, state.axes.get()};
    Tilting tilting(state.points, edit, rules);
    if (Result<void> done = tilting.run(movesToTilt(edit, state), progress); !done) return std::move(done).error();
    const std::vector<TiltedPoint> made = tilting.take();
    const bool stated = edit.from == ToolAxis::From::program;
    if (Result<void> clear = guardAxes(made, *guard, context, state.allowances, stated, progress); !clear)
        return std::move(clear).error();
    Deviation deviation;
    state.points.clear();
    for (const TiltedPoint& point : made) {
        deviation.include(glm::distance(point.point.pose.tip, point.before.tip), point.point.pose.tip);
        state.points.push_back(point.point);
    }
    return deviation;
}

} // namespace burin
