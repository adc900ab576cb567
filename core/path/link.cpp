// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/path/back_steps.h"
#include "core/path/cleared_heights.h"
#include "core/path/part_guard.h"
#include "core/path/round_corner.h"
#include "core/path/way_round.h"

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
        , rounding_(context.machine.rapids != RapidMode::independent ? edit.rounding : 0.0)
        , rapidsAreStraight_(context.machine.rapids != RapidMode::independent)
        , safeHeight_(safeHeight)
        , reach_(context.tool.cutter.diameter)
        , guard_(guard)
        , cleared_(context.stock, guard.pieces(), flutePieces(context.tool.cutter).size()) {
        if (context.cleared) cleared_.include(*context.cleared);
        area_ = context.stock;
        for (const ObstacleSolid& obstacle : context.obstacles)
            if (obstacle.on) area_.include(obstacle.surface->bounds());
        area_ = area_.grown(context.tool.cutter.diameter + edit.clearanceAbove);
        for (const ObstacleSolid& obstacle : context.obstacles)
            if (obstacle.on) obstacles_.emplace_back(PartGuard(*obstacle.surface, context.tool), obstacle.margin);
    }

    void add(const PathStroke& stroke, const Access& access) {
        const glm::dvec3& start = stroke.points.front().tip;
        const bool joined = !points.empty() && canJoin(start, std::min(lastRequired_, stroke.required));
        if (!joined) {
            const bool first = !goBack();
            if (!first) swingOut();
            const std::vector<glm::dvec3> swing = swingIn(stroke, access.entry);
            travel(first ? Way{safeHeight_, {}} : wayTo(points.back().tip, swing.front()), swing.front());
            enter(stroke, access, swing);
        }
        if (joined) cut(stroke, 0, {});
        for (std::size_t i = 1; i < stroke.points.size(); ++i) cut(stroke, i, stroke.points[i].arc);
        for (std::size_t i = stroke.points.size() - 1; i > access.exit; --i) back_.push_back({&stroke, i - 1});
        lastRequired_ = stroke.required;
    }

    /// Up to where nothing stands.
    void leave() {
        if (!goBack()) return;
        swingOut();
        const glm::dvec3 tip = points.back().tip;
        go(lift(safeHeight_), MoveKind::retract);
        if (points.back().tip.z < safeHeight_) go({tip.x, tip.y, safeHeight_}, MoveKind::rapid);
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

    /// The largest quarter of a circle up that keeps what the stroke keeps from the part, the margin of obstacles,
    /// shank and holder in empty space, and a free way up from its end; the tip alone where there is none or the stroke
    /// is not level.
    std::vector<glm::dvec3> swing(const glm::dvec3& tip, const glm::dvec3& move, double required) const {
        const double level = std::hypot(move.x, move.y);
        if (!(rounding_ > 0.0) || level < 1e-6 || std::abs(move.z) > 0.1 * level) return {tip};
        const glm::dvec3 direction(move.x / level, move.y / level, 0.0);
        double radius = std::min(rounding_, safeHeight_ - tip.z);
        for (int halving = 0; halving < 4 && radius > 0.1; ++halving, radius *= 0.5) {
            std::vector<glm::dvec3> places = quarterUp(tip, direction, radius);
            if (mayCut(places, required) && isClearAbove(places.back(), safeHeight_)) return places;
        }
        return {tip};
    }
    bool mayCut(const std::vector<glm::dvec3>& places, double required) const {
        const auto keeps = [&](const PartGuard& guard, double distance) {
            const double own = guard.clearance(places.front(), distance + 1.0).clearance;
            for (std::size_t i = 1; i < places.size(); ++i)
                if (!guard.isClear(places[i - 1], places[i], std::min(distance, own) - touchTolerance, defaultSampling))
                    return false;
            return true;
        };
        return std::ranges::all_of(places, [&](const glm::dvec3& place) { return cleared_.shankIsFree(place); }) &&
               keeps(guard_, required) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
                   return keeps(obstacle.first, obstacle.second);
               });
    }

    /// On from the end of a stroke and up, at the feed.
    void swingOut() {
        if (points.size() < 2 || points.back().kind != MoveKind::cut || points.back().arc) return;
        const glm::dvec3 tip = points.back().tip;
        const std::vector<glm::dvec3> places = swing(tip, tip - points[points.size() - 2].tip, lastRequired_);
        for (std::size_t i = 1; i < places.size(); ++i) {
            cleared_.cut(places[i - 1], places[i]);
            go(places[i], MoveKind::retract);
        }
    }

    /// From above to where a stroke is entered; that place alone where it is entered straight down.
    std::vector<glm::dvec3> swingIn(const PathStroke& stroke, std::size_t entry) const {
        const glm::dvec3& tip = stroke.points[entry].tip;
        if (entry != 0 || stroke.points.size() < 2 || stroke.points[1].arc) return {tip};
        std::vector<glm::dvec3> places = swing(tip, tip - stroke.points[1].tip, stroke.required);
        std::reverse(places.begin(), places.end());
        return places;
    }

    /// A level way from over one place to over another: straight, or by corners.
    struct Way {
        double height = 0.0; ///< mm
        std::vector<glm::dvec2> corners;
    };

    /// A little way up, which is made at the feed; and on as long as the flutes cut on it.
    glm::dvec3 lift(double height) const {
        const glm::dvec3& tip = points.back().tip;
        return {tip.x, tip.y, std::min(std::max(tip.z + approach_, cleared_.risenHeight(tip)), height)};
    }

    /// Up, across, and rapidly down to the approach above what is left over an entry.
    void travel(const Way& way, const glm::dvec3& entry) {
        std::vector<glm::dvec3> rapids;
        if (!points.empty()) {
            go(lift(way.height), MoveKind::retract);
            const glm::dvec3& tip = points.back().tip;
            rapids.push_back(tip);
            if (tip.z < way.height) rapids.emplace_back(tip.x, tip.y, way.height);
        }
        for (const glm::dvec2& corner : way.corners) rapids.emplace_back(corner, way.height);
        rapids.emplace_back(entry.x, entry.y, way.height);
        const double free = std::max(cleared_.freeHeight(entry.x, entry.y) + approach_, entry.z);
        if (free < way.height) rapids.emplace_back(entry.x, entry.y, free);
        const std::size_t first = points.empty() ? 0 : 1;
        if (rounding_ > 0.0) rapids = rounded(rapids);
        for (std::size_t i = first; i < rapids.size(); ++i) go(rapids[i], MoveKind::rapid);
    }

    /// The same way with its corners rounded inside, as far as there is room.
    std::vector<glm::dvec3> rounded(const std::vector<glm::dvec3>& way) const {
        std::vector<glm::dvec3> smooth;
        for (std::size_t i = 0; i < way.size(); ++i) {
            if (i == 0 || i + 1 == way.size()) {
                smooth.push_back(way[i]);
                continue;
            }
            const glm::dvec3 back = way[i - 1] - way[i], on = way[i + 1] - way[i];
            double leg = std::min({rounding_, 0.5 * glm::length(back), 0.5 * glm::length(on)});
            std::vector<glm::dvec3> arc{way[i]};
            for (int halving = 0; halving < 4; ++halving, leg *= 0.5) {
                const std::vector<glm::dvec3> wider = cornerArc(way[i], back, on, leg);
                if (!mayPass(wider)) continue;
                arc = wider;
                break;
            }
            smooth.insert(smooth.end(), arc.begin(), arc.end());
        }
        return smooth;
    }

    /// Rapids from place to place that stay above what is left, and clear of part and obstacles.
    bool mayPass(const std::vector<glm::dvec3>& places) const {
        for (std::size_t i = 1; i < places.size(); ++i) {
            const double height = std::min(places[i - 1].z, places[i].z);
            if (cleared_.freeHeight(places[i - 1], places[i]) + approach_ > height) return false;
            if (!isClear(places[i - 1], places[i])) return false;
        }
        return true;
    }

    /// Clear of the part, and of obstacles by their margins.
    bool isClear(const glm::dvec3& from, const glm::dvec3& to) const {
        return guard_.isClear(from, to, 0.0, defaultSampling) &&
               std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
                   return obstacle.first.isClear(from, to, obstacle.second, defaultSampling);
               });
    }
    /// The same between a stroke and a place above it: the stroke's own clearance is no obstacle to leaving.
    bool isClearAbove(const glm::dvec3& tip, double height) const {
        const auto passes = [&](const PartGuard& guard, double distance) {
            const double required = std::min(distance, guard.clearance(tip, distance + 1.0).clearance) - touchTolerance;
            return guard.isClear(tip, {tip.x, tip.y, height}, required, defaultSampling);
        };
        return passes(guard_, 0.0) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
                   return passes(obstacle.first, obstacle.second);
               });
    }
    /// Whether the tool may go straight on at a height, above what is left, clear of part and obstacles.
    bool isClearAcross(const glm::dvec2& from, const glm::dvec2& to, double height) const {
        const glm::dvec3 start(from, height), end(to, height);
        return cleared_.freeHeight(start, end) + approach_ <= height && isClear(start, end);
    }

    /// From the end of a stroke to the start of the next one.
    Way wayTo(const glm::dvec3& from, const glm::dvec3& to) const {
        if (travel_ == Link::Travel::safe) return {safeHeight_, {}};
        if (!rapidsAreStraight_ && from.x != to.x && from.y != to.y) return {safeHeight_, {}};
        const double height = std::max({cleared_.freeHeight(from, to), from.z, to.z}) + approach_;
        if (height >= safeHeight_) return around(from, to);
        const bool clear = isClearAbove(from, height) && isClearAbove(to, height) &&
                           isClear({from.x, from.y, height}, {to.x, to.y, height});
        return clear ? Way{height, {}} : around(from, to);
    }

    /// The shortest way, at one of some heights, round what stands there; else over everything.
    Way around(const glm::dvec3& from, const glm::dvec3& to) const {
        constexpr int levels = 4;
        Way best{safeHeight_, {}};
        if (travel_ != Link::Travel::around || !rapidsAreStraight_) return best;
        const double across = glm::distance(glm::dvec2(from), glm::dvec2(to));
        double shortest = 2.0 * safeHeight_ - from.z - to.z + across;
        const double lowest =
            std::max({cleared_.freeHeight(from.x, from.y), cleared_.freeHeight(to.x, to.y), from.z, to.z}) + approach_;
        const glm::dvec3 size = area_.size();
        const double step = std::max(0.5 * reach_, std::max(size.x, size.y) / 64.0);
        const WayRound search(area_, step);
        for (int level = 0; level < levels; ++level) {
            const double height = lowest + (safeHeight_ - lowest) * level / levels;
            const double longest = shortest - (2.0 * height - from.z - to.z);
            if (height >= safeHeight_ || longest <= across) continue;
            if (!isClearAbove(from, height) || !isClearAbove(to, height)) continue;
            const auto isFree = [&](const glm::dvec2& place) {
                const glm::dvec3 tip(place, height);
                const double spare = 0.25 * step;
                return cleared_.freeHeight(place.x, place.y) + approach_ <= height &&
                       guard_.clearance(tip, spare).clearance >= spare &&
                       std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
                           const double distance = obstacle.second + spare;
                           return obstacle.first.clearance(tip, distance).clearance >= distance;
                       });
            };
            const auto isSeen = [&](const glm::dvec2& a, const glm::dvec2& b) { return isClearAcross(a, b, height); };
            std::vector<glm::dvec2> corners = search.find(from, to, longest, isFree, isSeen);
            if (corners.empty()) continue;
            double length = 2.0 * height - from.z - to.z;
            glm::dvec2 at(from);
            for (const glm::dvec2& corner : corners) {
                length += glm::distance(at, corner);
                at = corner;
            }
            if (length >= shortest) continue;
            corners.pop_back(); // over the entry
            shortest = length;
            best = {height, std::move(corners)};
        }
        return best;
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

    /// To the stroke's first point at the plunge feed.
    void enter(const PathStroke& stroke, const Access& access, const std::vector<glm::dvec3>& swing) {
        const StrokePoint& entry = stroke.points[access.entry];
        for (const glm::dvec3& tip : swing) {
            cleared_.cut(points.back().tip, tip);
            points.push_back({tip, MoveKind::plunge, 0.0, stroke.take, entry.sample});
        }
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
    double rounding_; // mm
    bool rapidsAreStraight_;
    Box area_;                  // where ways round may lead
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
    const Deviation deviation = dropBackSteps(state, *guard, progress);
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
                         "no motion from above leads there without entering the part"};
        }
        linker.add(stroke, accesses[i]);
    }
    linker.leave();
    state.points = std::move(linker.points);
    state.strokes.clear();
    state.linked = true;
    return deviation;
}

} // namespace burin
