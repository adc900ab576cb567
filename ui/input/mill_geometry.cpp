// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/mill_geometry.h"

#include "core/volume/operations/ray_cast.h"

#include <Qt>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double besideStock = 20.0; // mm beyond the tool's radius by which the tip may leave the grid

/// Highest run end within a radius of any point of a move, from discs a radius apart that are wide enough to leave no
/// gap at the move's edges.
double highestAlong(const VolumeSnapshot& workpiece, const glm::dvec2& from, const glm::dvec2& to, double radius) {
    const double length = glm::distance(from, to);
    const int steps = static_cast<int>(std::ceil(length / std::max(radius, workpiece.grid().edge())));
    const double wide = steps == 0 ? radius : std::hypot(radius, 0.5 * length / steps);
    double highest = highestWithin(workpiece, to, wide);
    for (int i = 0; i < steps; ++i)
        highest = std::max(highest, highestWithin(workpiece, glm::mix(from, to, static_cast<double>(i) / steps), wide));
    return highest;
}

} // namespace

std::optional<glm::dvec3> onLevel(const Sight& sight, double height) {
    const double way = (height - sight.origin.z) / sight.direction.z;
    if (!std::isfinite(way) || way < 0.0) return std::nullopt;
    glm::dvec3 place = sight.origin + sight.direction * way;
    place.z = height;
    return place;
}

double clearTipHeight(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec2& from,
                      const glm::dvec2& to) {
    const Grid& grid = workpiece.grid();
    if (grid.axis() != RunAxis::z) return grid.box().high.z + hoverClearance;
    double height = grid.low().z;
    for (const RevolvedPiece& piece : pieces(cutter)) {
        height = std::max(height, highestAlong(workpiece, from, to, piece.widestRadius()) - piece.bottom);
    }
    return height + hoverClearance;
}

Box strokeReach(const VolumeSnapshot& workpiece, const Cutter& cutter) {
    return workpiece.grid().box().grown(cutter.radius() + besideStock);
}

glm::dvec3 keptWithin(const Box& box, const glm::dvec3& place) {
    return {std::clamp(place.x, box.low.x, box.high.x), std::clamp(place.y, box.low.y, box.high.y), place.z};
}

glm::dvec3 keyStep(int key, const glm::dvec3& lookingAlong) {
    if (key == Qt::Key_PageUp) return {0.0, 0.0, 1.0};
    if (key == Qt::Key_PageDown) return {0.0, 0.0, -1.0};
    glm::dvec3 away(0.0, 1.0, 0.0); // also for a vertical view
    if (std::abs(lookingAlong.x) > std::max(std::abs(lookingAlong.y), 1e-3))
        away = {lookingAlong.x > 0.0 ? 1.0 : -1.0, 0.0, 0.0};
    else if (lookingAlong.y < -1e-3)
        away = {0.0, -1.0, 0.0};
    const glm::dvec3 right(away.y, -away.x, 0.0);
    switch (key) {
    case Qt::Key_Up:
        return away;
    case Qt::Key_Down:
        return -away;
    case Qt::Key_Right:
        return right;
    case Qt::Key_Left:
        return -right;
    default:
        return glm::dvec3(0.0);
    }
}

} // namespace burin
