// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/path/apply.h"
#include "core/path/part_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// The distance along the stroke from each point to the nearest one of the interval, mm.
std::vector<double> distancesAlong(const SourceInterval& interval, const PathStroke& stroke) {
    const std::vector<StrokePoint>& points = stroke.points;
    std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (contains(interval, stroke, points[i]))
            distances[i] = 0.0;
        else if (i > 0)
            distances[i] = distances[i - 1] + glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
    }
    for (std::size_t i = points.size(); i-- > 1;)
        distances[i - 1] =
            std::min(distances[i - 1], distances[i] + glm::distance(points[i - 1].pose.tip, points[i].pose.tip));
    return distances;
}

/// Moves along the part, at constant distance from it. Far from the part there is no surface to follow.
glm::dvec3 movedOnSurface(const glm::dvec3& tip, const glm::dvec3& by, const PartGuard& guard) {
    constexpr double farthest = 10.0;  // mm from the part
    constexpr double precision = 1e-4; // mm
    constexpr int attempts = 20;
    const ToolClearance before = guard.clearance(tip, farthest);
    if (before.clearance >= farthest) return tip + by;
    glm::dvec3 moved = tip + by - glm::dot(by, before.away) * before.away;
    for (int i = 0; i < attempts; ++i) {
        const ToolClearance now = guard.clearance(moved, 2.0 * farthest);
        const double missing = before.clearance - now.clearance;
        if (std::abs(missing) < precision) break;
        moved += missing * now.away;
    }
    return moved;
}

} // namespace

double MovePoints::shareAt(double way) const noexcept {
    if (way <= 0.0) return 1.0;
    return way < falloff ? 0.5 + 0.5 * std::cos(pi * way / falloff) : 0.0;
}

Result<Deviation> apply(const MovePoints& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    std::optional<PartGuard> guard;
    if (edit.along == MovePoints::Along::surface) {
        Result<PartGuard> made = PartGuard::of(context);
        if (!made) return made.error();
        guard.emplace(std::move(*made));
    }
    for (PathStroke& stroke : state.strokes) {
        const std::vector<double> distances = distancesAlong(edit.interval, stroke);
        for (std::size_t i = 0; i < distances.size() && !progress.cancelled(); ++i) {
            const double weight = edit.shareAt(distances[i]);
            if (weight <= 0.0) continue;
            glm::dvec3& tip = stroke.points[i].pose.tip;
            tip = guard ? movedOnSurface(tip, weight * edit.by, *guard) : tip + weight * edit.by;
        }
    }
    return Deviation{}; // changed on purpose
}

} // namespace burin
