// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/pose.h"
#include "core/haptics/axis_turn.h"
#include "core/setup/guide.h"

namespace burin {

/// Turns the tool's axis to a fixed lead and tilt: from the normal of the part or of the guide, towards where the tool
/// goes, and to its left. Turns no faster than a hand. Tick code.
class GuideAxis {
public:
    static constexpr double feedLength = 0.5; ///< mm, over which the direction of motion is seen

    /// As before the first tick: no direction of motion is known.
    void forget() noexcept;
    /// @param guide nullptr: none holds, the axis goes back to the hand's. @param goal of the tool's tip, mm
    /// @return unit
    glm::dvec3 lean(const Guide* guide, const ClearanceField& field, const ToolPose& hand, const glm::dvec3& goal,
                    double period) noexcept;
    /// Unit; zero until the tool has moved. It keeps while the tool stands.
    const glm::dvec3& feed() const noexcept { return feed_; }

private:
    void follow(const glm::dvec3& goal) noexcept;
    glm::dvec3 wanted(const Guide& guide, const ClearanceField& field, const glm::dvec3& goal) noexcept;

    glm::dvec3 behind_{0.0}; ///< mm, drawn behind the goal on a rope: a tractrix knows no noise
    glm::dvec3 feed_{0.0};
    glm::dvec3 normal_{0.0}; ///< of the part, where it was known last
    glm::dvec3 handAxis_{0.0};
    AxisFollower follower_;
    bool known_ = false;
};

} // namespace burin
