// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/milling_side.h"

#include "core/geometry/arc.h"
#include "core/geometry/upright.h"
#include "core/path/part_guard.h"

#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double flattest = 1e-6; // mm in plan: shorter moves are straight up or down
/// Position, beside the axis and ahead of it, at which stock is looked for, in radii: just beyond the area of the
/// flutes.
constexpr double beside = 0.95, ahead = 0.45;
/// Stock that is no higher above the flutes' edge than this is not cut by their side, mm.
constexpr double least = 0.02;
/// The part is beside the tool if the sine of the angle between its direction and the motion is at least this.
constexpr double across = 0.25;

MillingSide sideOf(bool left, bool right) {
    if (left == right) return MillingSide::neither;
    return right ? MillingSide::climb : MillingSide::conventional;
}

/// Evaluates the moves in order, and cuts each out of the height map.
class SideFinder {
public:
    SideFinder(const PathContext& context, const PartGuard& guard)
        : guard_(guard)
        , radius_(context.tool.cutter.radius())
        , edgeHeight_(heightsAt(guard.pieces().front(), beside * radius_).value_or(HeightRange{}).low)
        , left_(context.stock, guard.pieces(), flutePieces(context.tool.cutter).size(), context.tool.cutter.hollow()) {
        if (context.cleared) left_.include(*context.cleared);
    }

    /// What a tilted tool clears is not known from above: it counts as standing.
    MillingSide cut(const ToolPose& start, const PathPoint& to) {
        if (!isUpright(start.axis) || !isUpright(to.pose.axis)) return MillingSide::neither;
        const glm::dvec3& from = start.tip;
        const MillingSide side = look(from, to);
        if (to.kind != MoveKind::rapid && to.arc)
            left_.cut(Arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise});
        else if (to.kind != MoveKind::rapid)
            left_.cut(from, to.pose.tip);
        return side;
    }
    HeightMap takeCleared() { return std::move(left_); }

private:
    MillingSide look(const glm::dvec3& from, const PathPoint& to) const {
        if (to.kind != MoveKind::cut) return MillingSide::neither;
        glm::dvec3 place = glm::mix(from, to.pose.tip, 0.5), way = to.pose.tip - from;
        if (to.arc) {
            const Arc arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
            const ArcTurn turn = turnOf(arc);
            place = placeOn(arc, turn, 0.5);
            way = placeOn(arc, turn, 0.501) - placeOn(arc, turn, 0.499);
        }
        const double length = std::hypot(way.x, way.y);
        if (length < flattest) return MillingSide::neither;
        const glm::dvec3 side(-way.y / length, way.x / length, 0.0);
        const auto stands = [&](double sign) {
            return left_.heightAt(place + radius_ * (ahead / length * glm::dvec3(way.x, way.y, 0.0) +
                                                     sign * beside * side)) > place.z + edgeHeight_ + least;
        };
        const MillingSide byStock = sideOf(stands(1.0), stands(-1.0));
        return byStock != MillingSide::neither ? byStock : byPart(place, side);
    }

    MillingSide byPart(const glm::dvec3& place, const glm::dvec3& side) const {
        const ToolClearance found = guard_.clearance(place, radius_);
        if (found.clearance >= radius_) return MillingSide::neither;
        const double toLeft = -glm::dot(found.away, side);
        return std::abs(toLeft) < across ? MillingSide::neither : sideOf(toLeft > 0.0, toLeft < 0.0);
    }

    const PartGuard& guard_;
    double radius_, edgeHeight_; // mm, of the flutes; above the tip, where stock is looked for
    HeightMap left_;
};

} // namespace

Result<MilledSides> millingSides(const Path& path, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    if (context.stock.empty()) return Error{ErrorCode::argumentInvalid, "stock", "", "a box that is not empty"};
    SideFinder finder(context, *guard);
    MilledSides sides;
    std::vector<MillingInterval>& intervals = sides.intervals;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, path.name, "", ""};
        progress.report(static_cast<double>(i) / static_cast<double>(path.points.size()));
        const MillingSide side = finder.cut(path.points[i - 1].pose, path.points[i]);
        if (intervals.empty() || intervals.back().side != side) intervals.push_back({i, i, side});
        intervals.back().last = i;
    }
    sides.cleared = std::make_shared<const HeightMap>(finder.takeCleared());
    return sides;
}

std::array<double, 3> lengthsBySide(const Path& path, const std::vector<MillingInterval>& intervals) {
    std::array<double, 3> lengths{};
    for (const MillingInterval& interval : intervals)
        for (std::size_t i = interval.first; i <= interval.last && i < path.points.size(); ++i)
            if (path.points[i].kind == MoveKind::cut)
                lengths[static_cast<std::size_t>(interval.side)] +=
                    lengthOf(path.points[i - 1].pose.tip, path.points[i]);
    return lengths;
}

} // namespace burin
