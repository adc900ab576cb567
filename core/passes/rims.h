// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <glm/glm.hpp>

namespace burin {

/// mm that the hand keeps above a rim, and how far beside where it aims it may come: more than its tremor.
inline constexpr double overRim = 0.3, swerve = 0.25;
/// mm between where the hand turns and a rim that it does not go over.
inline constexpr double turningRoom = 1.0;

/// Where the surface of tips has walls. The part holds the tool at the face that it came along, so a hand that presses
/// behind a rim leaves the tool at the wall: it stays there while the hand goes on. Slopes lead the tool on.
class OperatorRims {
public:
    /// Keeps a reference to the field. @param top, bottom heights between which tips are looked for, mm
    OperatorRims(const ClearanceField& field, double top, double bottom) : field_(field), top_(top), bottom_(bottom) {}

    /// Where a tip that comes down at a place is stopped, mm: see lowestFeasibleHeight.
    double reachedAt(const glm::dvec2& place) const noexcept;
    /// Whether a wall stands between two places. @param low, high mm, where a tip is stopped there; false where it does
    /// not rise
    bool isWall(glm::dvec2 from, double low, glm::dvec2 to, double high) const noexcept;
    /// How far below the surface the hand may aim at a place, mm, and the tool stay on the surface in spite of tremor:
    /// `press`, or as much less as a wall downwards is near; at one itself negative.
    /// @param reached mm, where a tip is stopped there
    double pressAt(const glm::dvec2& place, double reached, double press) const noexcept;
    /// Whether a hand that turns back at a place may pull the tool over a rim: in a direction, a wall downwards is
    /// nearer than `turningRoom`. A fast hand rounds its turn, so that it comes down while it is still there.
    /// @param reached mm, where a tip is stopped there. @param direction unit
    bool isTurnAtRim(const glm::dvec2& place, double reached, const glm::dvec2& direction) const noexcept;

private:
    const ClearanceField& field_;
    double top_, bottom_; // mm
};

} // namespace burin
