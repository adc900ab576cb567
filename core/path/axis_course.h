// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/evaluate.h"
#include "core/path/machine_edits.h"
#include "core/path/part_guard.h"
#include "core/path/stated_axes.h"

#include <span>
#include <vector>

namespace burin {

/// A point of a path whose tool axis an edit sets.
struct TiltedPoint {
    PathPoint point;       ///< with the new pose; straight
    ToolPose before;       ///< its pose without the edit
    bool inserted = false; ///< not a point of the path before
    bool changed() const noexcept { return point.pose.tip != before.tip || point.pose.axis != before.axis; }
};

/// What the axes of a part of a path depend on.
struct AxisRules {
    const ToolAxis& edit;
    const PathContext& context;
    const PartGuard& guard;
    const StatedAxes* stated = nullptr; ///< of ToolAxis::From::program
};

/// The points of a part of a path with their new axes, in place of the given ones.
/// @param points consecutive, the first one is where the part begins @param blendsIn, blendsOut whether the axis turns
/// inside it at its ends
/// Errors: argumentInvalid (nothing of the part is near), cancelled.
Result<std::vector<TiltedPoint>> tiltedCourse(std::span<const PathPoint> points, bool blendsIn, bool blendsOut,
                                              const AxisRules& rules, const Progress& progress);

/// How far a tool with this axis reaches from its tip in a direction, mm: the flutes alone. Both of unit length.
double fluteReach(std::span<const RevolvedPiece> flutes, const glm::dvec3& axis, const glm::dvec3& direction) noexcept;

/// The direction at a share of the turn from one to another, both of unit length, on the shortest way.
glm::dvec3 directionBetween(const glm::dvec3& from, const glm::dvec3& to, double share) noexcept;

} // namespace burin
