// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/path/arc_fit.h"
#include "core/path/part_guard.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double sharpest = 170.0 * pi / 180.0; // turn
constexpr double chordTolerance = 0.001;        // mm, of a parabola's chords
/// Number of halvings of the distance from the corner that are tried if the part is in the way.
constexpr int attempts = 3;

/// A corner and its legs.
struct Corner {
    glm::dvec3 place, in, out; ///< directions of both moves, unit
    double turn = 0.0;         ///< rad
    double longestLeg = 0.0;   ///< mm
};

/// The replacement of a corner: moves that begin on one leg and end on the other.
struct Rounding {
    glm::dvec3 start{0.0};
    std::vector<StrokePoint> points; ///< ends of its moves
    double distance = 0.0;           ///< mm from the corner
};

class Rounder {
public:
    Rounder(const RoundCorners& edit, const PartGuard& guard, const PathContext& context) : edit_(edit), guard_(guard) {
        rules_.radiusMismatch = std::min(FitArcs{}.radiusMismatch, context.machine.arcs.radiusMismatch);
        rules_.smallestRadius = context.machine.arcs.smallestRadius;
        rules_.largestRadius = context.machine.arcs.largestRadius;
        rules_.figure = std::pow(10.0, -context.machine.coordinateDecimals);
        rules_.programZero = context.workOffset;
    }

    std::optional<Rounding> round(const Corner& corner, const StrokePoint& point, double required) const {
        if (corner.turn < edit_.smallestTurn || corner.turn > sharpest) return {};
        double distance = edit_.tolerance;
        for (int i = 0; i < attempts; ++i, distance *= 0.5) {
            std::optional<Rounding> rounding = arc(corner, point, distance);
            if (!rounding) rounding = parabola(corner, point, distance);
            if (isClear(*rounding, required)) return rounding;
        }
        return {};
    }

private:
    /// An arc in one of the three planes, if neither move has a component along its axis.
    std::optional<Rounding> arc(const Corner& corner, const StrokePoint& point, double distance) const {
        const auto isLevel = [&](int axis) {
            return std::max(std::abs(corner.in[axis]), std::abs(corner.out[axis])) < 1e-9;
        };
        const int axis = isLevel(2) ? 2 : isLevel(1) ? 1 : 0;
        if (!isLevel(axis)) return {};
        const double half = 0.5 * (pi - corner.turn), perDistance = 1.0 / (1.0 / std::sin(half) - 1.0);
        const double leg = std::min(distance * perDistance / std::tan(half), corner.longestLeg);
        const double radius = leg * std::tan(half);
        const glm::dvec3 start = corner.place - leg * corner.in, end = corner.place + leg * corner.out;
        const glm::dvec3 inward = glm::normalize(corner.out - corner.in);
        const glm::dvec3 ideal = corner.place + radius / std::sin(half) * inward;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto plane = [&](const glm::dvec3& place) { return glm::dvec2(place[u], place[v]); };
        const auto centre = roundedCentre(plane(ideal), plane(start), plane(end), plane(rules_.programZero), rules_);
        if (!centre || glm::distance(start, end) < 16.0 * rules_.figure) return {};
        if (radius < rules_.smallestRadius || radius > rules_.largestRadius) return {};
        Rounding rounding;
        rounding.start = start;
        rounding.distance = radius / perDistance;
        PathArc turn{start, axis, corner.in[u] * corner.out[v] - corner.in[v] * corner.out[u] < 0.0};
        turn.centre[u] = centre->x;
        turn.centre[v] = centre->y;
        rounding.points = {point};
        rounding.points.front().pose.tip = end;
        rounding.points.front().arc = turn;
        return rounding;
    }

    Rounding parabola(const Corner& corner, const StrokePoint& point, double distance) const {
        const double half = 0.5 * (pi - corner.turn);
        const double leg = std::min(2.0 * distance / std::cos(half), corner.longestLeg);
        Rounding rounding;
        rounding.start = corner.place - leg * corner.in;
        rounding.distance = 0.5 * leg * std::cos(half);
        const glm::dvec3 end = corner.place + leg * corner.out;
        const auto count = static_cast<int>(std::ceil(std::sqrt(rounding.distance / chordTolerance)));
        for (int i = 1; i <= count; ++i) {
            const double t = static_cast<double>(i) / count, s = 1.0 - t;
            rounding.points.push_back(point);
            rounding.points.back().pose.tip = s * s * rounding.start + 2.0 * s * t * corner.place + t * t * end;
        }
        return rounding;
    }

    bool isClear(const Rounding& rounding, double required) const {
        glm::dvec3 at = rounding.start;
        return std::ranges::all_of(rounding.points, [&](const StrokePoint& point) {
            const glm::dvec3 from = at;
            at = point.pose.tip;
            if (!point.arc) return guard_.isClear(from, at, required, defaultSampling);
            return guard_.isClear(Arc{from, at, point.arc->centre, point.arc->axis, point.arc->clockwise}, required,
                                  defaultSampling);
        });
    }

    const RoundCorners& edit_;
    const PartGuard& guard_;
    ArcFitRules rules_;
};

std::optional<Corner> cornerAt(const std::vector<StrokePoint>& points, std::size_t i) {
    if (points[i].arc || points[i + 1].arc) return {};
    const glm::dvec3 in = points[i].pose.tip - points[i - 1].pose.tip,
                     out = points[i + 1].pose.tip - points[i].pose.tip;
    const double before = glm::length(in), behind = glm::length(out);
    if (!(before > 0.0) || !(behind > 0.0)) return {};
    Corner corner{points[i].pose.tip, in / before, out / behind, 0.0, 0.5 * std::min(before, behind)};
    corner.turn = std::acos(glm::clamp(glm::dot(corner.in, corner.out), -1.0, 1.0));
    return corner;
}

Deviation roundStroke(PathStroke& stroke, const Rounder& rounder) {
    Deviation deviation;
    if (stroke.points.size() < 3) return deviation;
    std::vector<StrokePoint> rounded{stroke.points.front()};
    for (std::size_t i = 1; i + 1 < stroke.points.size(); ++i) {
        const std::optional<Corner> corner = cornerAt(stroke.points, i);
        const auto rounding = corner ? rounder.round(*corner, stroke.points[i], stroke.required) : std::nullopt;
        rounded.push_back(stroke.points[i]);
        if (!rounding) continue;
        rounded.back().pose.tip = rounding->start;
        rounded.insert(rounded.end(), rounding->points.begin(), rounding->points.end());
        deviation.include(rounding->distance + chordTolerance, corner->place); // moving to the grid changes it by less
    }
    rounded.push_back(stroke.points.back());
    stroke.points = std::move(rounded);
    return deviation;
}

} // namespace

Result<Deviation> apply(const RoundCorners& edit, PathUnderEdit& state, const PathContext& context,
                        Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    const Rounder rounder(edit, *guard, context);
    std::vector<Deviation> deviations(state.strokes.size());
    parallelFor(std::size_t{0}, deviations.size(), [&](std::size_t i) {
        if (!progress.cancelled()) deviations[i] = roundStroke(state.strokes[i], rounder);
    });
    Deviation deviation;
    for (const Deviation& one : deviations) deviation.include(one);
    return deviation;
}

} // namespace burin
