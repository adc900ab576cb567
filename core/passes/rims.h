// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <glm/glm.hpp>

namespace burin {

/// Height that the hand keeps above a rim, and how far the hand may deviate sideways from its aim, mm: more than its
/// tremor.
inline constexpr double overRim = 0.3, swerve = 0.25;
/// Distance between the point where the hand turns and a rim that it does not cross, mm.
inline constexpr double turningRoom = 1.0;

/// Finds where the surface of tips has walls. The part holds the tool at the face along which it came, so that a hand
/// that presses behind a rim leaves the tool at the wall while the hand itself moves on. Slopes do not hold the tool.
class OperatorRims {
public:
    /// Keeps a reference to the field. @param top, bottom heights between which tip positions are searched, mm
    OperatorRims(const ClearanceField& field, double top, double bottom) : field_(field), top_(top), bottom_(bottom) {}

    /// The height at which a tip that comes down at a point is stopped, mm, see lowestFeasibleHeight.
    double reachedAt(const glm::dvec2& place) const noexcept;
    /// Whether a wall stands between two points. @param low, high heights at which a tip is stopped at these points,
    /// mm; false if `high` is not above `low`
    bool isWall(glm::dvec2 from, double low, glm::dvec2 to, double high) const noexcept;
    /// How far below the surface the hand may aim at a point, mm, so that the tool stays on the surface in spite of
    /// tremor: `press`, less near a wall that drops downwards; negative at the wall itself.
    /// @param reached height at which a tip is stopped there, mm
    double pressAt(const glm::dvec2& place, double reached, double press) const noexcept;
    /// Whether a hand that turns back at a point may pull the tool over a rim: in the given direction, a wall that
    /// drops downwards is closer than `turningRoom`. A fast hand rounds its turn and so comes down while it is still
    /// there.
    /// @param reached height at which a tip is stopped there, mm @param direction unit vector
    bool isTurnAtRim(const glm::dvec2& place, double reached, const glm::dvec2& direction) const noexcept;

private:
    const ClearanceField& field_;
    double top_, bottom_; // mm
};

} // namespace burin
