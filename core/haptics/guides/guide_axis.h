// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/pose.h"
#include "core/haptics/axis_turn.h"
#include "core/setup/guide.h"

namespace burin {

/// Rotates the tool's axis to a fixed lead and tilt angle: from the normal of the part or of the guide, towards the
/// direction of motion, and to the left of it. Rotates no faster than a hand. Called in the haptic tick.
class GuideAxis {
public:
    static constexpr double feedLength = 0.5; ///< mm, distance over which the direction of motion is determined

    /// Returns to the state before the first tick: no direction of motion is known.
    void forget() noexcept;
    /// @param guide nullptr: no guide holds the hand, the axis returns to the hand's. @param goal of the tool's tip, mm
    /// @return unit
    glm::dvec3 lean(const Guide* guide, const ClearanceField& field, const ToolPose& hand, const glm::dvec3& goal,
                    double period) noexcept;
    /// The direction of motion, unit; zero until the tool has moved. It is kept while the tool is at rest.
    const glm::dvec3& feed() const noexcept { return feed_; }

private:
    void follow(const glm::dvec3& goal) noexcept;
    glm::dvec3 wanted(const Guide& guide, const ClearanceField& field, const glm::dvec3& goal) noexcept;

    glm::dvec3 behind_{0.0}; ///< mm, dragged behind the goal at a fixed distance: a tractrix suppresses noise
    glm::dvec3 feed_{0.0};
    glm::dvec3 normal_{0.0}; ///< of the part, where it was last known
    glm::dvec3 handAxis_{0.0};
    AxisFollower follower_;
    bool known_ = false;
};

} // namespace burin
