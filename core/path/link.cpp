// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/path/cleared_heights.h"
#include "core/path/part_guard.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double touchTolerance = 1e-6; // mm; a tool that lies on the part does not enter it

/// Which points of a stroke the tool can get to from above, and leave upwards. On a part without undercuts these are
/// its ends; under an overhang the tool goes back along the stroke until the way up is free.
struct Access {
    std::size_t entry = 0, exit = 0;
    bool found = false;
};

bool isFreeAbove(const PartGuard& guard, const glm::dvec3& tip, double height) {
    constexpr double sampling = 0.25; // mm
    // A path that was not held out of the part may start inside; its own depth is no obstacle to leaving.
    const double required = std::min(0.0, guard.clearance(tip, 1.0).clearance) - touchTolerance;
    return guard.isClear(tip, {tip.x, tip.y, height}, required, sampling);
}

Access accessOf(const PathStroke& stroke, const PartGuard& guard, double height) {
    const std::size_t count = stroke.points.size();
    Access access;
    while (access.entry < count && !isFreeAbove(guard, stroke.points[access.entry].tip, height)) ++access.entry;
    if (access.entry == count) return access;
    access.found = true;
    access.exit = count - 1;
    while (access.exit > access.entry && !isFreeAbove(guard, stroke.points[access.exit].tip, height)) --access.exit;
    return access;
}

/// The same arc, gone the other way.
std::optional<PathArc> reversed(std::optional<PathArc> arc) {
    if (arc) arc->clockwise = !arc->clockwise;
    return arc;
}

/// Strings strokes together.
class Linker {
public:
    Linker(const Link& edit, const PartGuard& guard, const PathContext& context, double safeHeight)
        : approach_(edit.approach)
        , travel_(edit.travel)
        , safeHeight_(safeHeight)
        , reach_(context.tool.cutter.diameter)
        , guard_(guard)
        , cleared_(context.stock, guard.pieces(), flutePieces(context.tool.cutter).size()) {
        for (const ObstacleSolid& obstacle : context.obstacles)
            if (obstacle.on) obstacles_.emplace_back(PartGuard(*obstacle.surface, context.tool), obstacle.margin);
    }

    void add(const PathStroke& stroke, const Access& access) {
        const glm::dvec3& start = stroke.points.front().tip;
        const bool joined = !points.empty() && canJoin(start, std::min(lastRequired_, stroke.required));
        if (!joined) {
            const double height =
                goBack() ? travelHeight(points.back().tip, stroke.points[access.entry].tip) : safeHeight_;
            rise(height);
            enter(stroke, access, height);
        }
        if (joined) cut(stroke, 0, {});
        for (std::size_t i = 1; i < stroke.points.size(); ++i) cut(stroke, i, stroke.points[i].arc);
        for (std::size_t i = stroke.points.size() - 1; i > access.exit; --i) back_.push_back({&stroke, i - 1});
        lastRequired_ = stroke.required;
    }

    /// Up to where nothing stands.
    void leave() {
        if (goBack()) rise(safeHeight_);
    }

    std::vector<PathPoint> points;

private:
    void go(const glm::dvec3& tip, MoveKind kind) { points.push_back({tip, kind, 0.0, 0, -1}); }

    /// To where the last stroke can be left. @return false where there was none
    bool goBack() {
        if (points.empty()) return false;
        for (const auto& [stroke, index] : back_) cut(*stroke, index, reversed(stroke->points[index + 1].arc));
        back_.clear();
        return true;
    }

    /// Up to a height, a little of it at the feed.
    void rise(double height) {
        if (points.empty()) return;
        const glm::dvec3 tip = points.back().tip;
        const double near = std::min(tip.z + approach_, height);
        go({tip.x, tip.y, near}, MoveKind::retract);
        if (near < height) go({tip.x, tip.y, height}, MoveKind::rapid);
    }

    /// At which the tool goes from the end of a stroke to the start of the next one.
    double travelHeight(const glm::dvec3& from, const glm::dvec3& to) const {
        if (travel_ == Link::Travel::safe) return safeHeight_;
        const double height = std::max({cleared_.freeHeight(from, to), from.z, to.z}) + approach_;
        if (height >= safeHeight_) return safeHeight_;
        const glm::dvec3 start(from.x, from.y, height), end(to.x, to.y, height);
        const auto passes = [&](const PartGuard& guard, double distance) {
            return guard.isClear(from, start,
                                 std::min(distance, guard.clearance(from, distance + 1.0).clearance) - touchTolerance,
                                 defaultSampling) &&
                   guard.isClear(start, end, distance, defaultSampling) &&
                   guard.isClear(end, to,
                                 std::min(distance, guard.clearance(to, distance + 1.0).clearance) - touchTolerance,
                                 defaultSampling);
        };
        const bool clear = passes(guard_, 0.0) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
                               return passes(obstacle.first, obstacle.second);
                           });
        return clear ? height : safeHeight_;
    }

    /// To a point of a stroke, along the arc or straight.
    void cut(const PathStroke& stroke, std::size_t index, const std::optional<PathArc>& arc) {
        const StrokePoint& point = stroke.points[index];
        const glm::dvec3 from = points.empty() ? point.tip : points.back().tip;
        if (arc)
            cleared_.cut(Arc{from, point.tip, arc->centre, arc->axis, arc->clockwise});
        else
            cleared_.cut(from, point.tip);
        points.push_back({point.tip, MoveKind::cut, 0.0, stroke.take, point.sample, arc});
    }

    /// To the stroke's first point: across at a height, rapidly down to the approach above what is left there,
    /// and on at the plunge feed.
    void enter(const PathStroke& stroke, const Access& access, double height) {
        const StrokePoint& entry = stroke.points[access.entry];
        const glm::dvec3& tip = entry.tip;
        go({tip.x, tip.y, height}, MoveKind::rapid);
        const double free = std::max(cleared_.freeHeight(tip.x, tip.y) + approach_, tip.z);
        if (free < height) go({tip.x, tip.y, free}, MoveKind::rapid);
        cleared_.cut(points.back().tip, tip);
        points.push_back({tip, MoveKind::plunge, 0.0, stroke.take, entry.sample});
        for (std::size_t i = access.entry; i > 0; --i) cut(stroke, i - 1, reversed(stroke.points[i].arc));
    }

    /// Whether the tool may go straight on at its cutting feed: not far, clear of part and obstacles, and shank and
    /// holder in empty space. What lies in between meets the flutes at the feed that is theirs.
    bool canJoin(const glm::dvec3& start, double required) const {
        if (!back_.empty()) return false;
        const glm::dvec3& end = points.back().tip;
        const double length = glm::distance(end, start);
        if (length > reach_ || !guard_.isClear(end, start, required, defaultSampling)) return false;
        for (const auto& [obstacle, margin] : obstacles_)
            if (!obstacle.isClear(end, start, 0.0, defaultSampling)) return false;
        constexpr double sampling = 0.25; // mm
        const int steps = std::max(1, static_cast<int>(length / sampling) + 1);
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec3 tip = end + (static_cast<double>(i) / steps) * (start - end);
            if (!cleared_.shankIsFree(tip)) return false;
        }
        return true;
    }

    double approach_; // mm
    Link::Travel travel_;
    double safeHeight_, reach_; // mm
    double lastRequired_ = 0.0; // mm from the part, of the stroke before
    const PartGuard& guard_;
    std::vector<std::pair<PartGuard, double>> obstacles_; // with the margin to keep, mm
    ClearedHeights cleared_;
    std::vector<std::pair<const PathStroke*, std::size_t>> back_; // the way to where the last stroke can be left
};

/// Above the stock, the part, every tip, and what stands there, but for what hangs above all of them.
double safeHeightOf(const Link& edit, const PathUnderEdit& state, const PathContext& context, const PartGuard& guard) {
    double height = std::max(context.stock.high.z, guard.top()) + edit.clearanceAbove;
    for (const PathStroke& stroke : state.strokes) {
        for (const StrokePoint& point : stroke.points) height = std::max(height, point.tip.z);
    }
    const double working = height;
    for (const ObstacleSolid& obstacle : context.obstacles) {
        const Box box = obstacle.surface->bounds();
        if (obstacle.on && box.low.z < working)
            height = std::max(height, box.high.z + obstacle.margin + edit.clearanceAbove);
    }
    return height;
}

} // namespace

Result<Deviation> apply(const Link& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    if (context.stock.empty()) return Error{ErrorCode::argumentInvalid, "stock", "", "links need the stock's box"};
    std::erase_if(state.strokes, [](const PathStroke& stroke) { return stroke.points.empty(); });
    const double height = safeHeightOf(edit, state, context, *guard);
    std::vector<Access> accesses(state.strokes.size());
    parallelFor(std::size_t{0}, accesses.size(), [&](std::size_t i) {
        if (!progress.cancelled()) accesses[i] = accessOf(state.strokes[i], *guard, height);
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
    Linker linker(edit, *guard, context, height);
    for (std::size_t i = 0; i < accesses.size(); ++i) {
        const PathStroke& stroke = state.strokes[i];
        if (!accesses[i].found) {
            const StrokePoint& point = stroke.points.front();
            return Error{ErrorCode::pathGouges, "take " + std::to_string(stroke.take),
                         "sample " + std::to_string(point.sample),
                         "no way from above leads there without entering the part"};
        }
        linker.add(stroke, accesses[i]);
    }
    linker.leave();
    state.points = std::move(linker.points);
    state.strokes.clear();
    state.linked = true;
    return Deviation{};
}

} // namespace burin
