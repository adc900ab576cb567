// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"

#include <cstdint>
#include <span>

namespace burin {

/// A straight move of a tool with a fixed axis.
struct PoseStep {
    glm::dvec3 fromTip{0.0}, toTip{0.0}; ///< mm
    glm::dvec3 axis{0.0, 0.0, 1.0};      ///< unit length
};

/// Returns the distance of the farthest point of a tool's pieces from its tip, mm.
double reachOf(std::span<const RevolvedPiece> pieces) noexcept;

/// A change of a tool's pose, split into straight steps with a fixed axis. The true motion moves the tip along a
/// straight line at constant speed and rotates the axis at constant speed about the common normal of its two directions
/// (the paper's interpolation, eqs. 6 and 7, without the rotation about the tool's own axis, which has no effect on a
/// cutter of revolution). Step k has the axis of the true motion at k / (count - 1) and represents the time around it,
/// so that
/// - no point of the tool within `reach` of the tip is ever farther than `tolerance` from its position in the true
///   motion (the paper asks for less than a voxel, eq. 8),
/// - the steps are continuous: each begins at the tip position at which the previous one ends,
/// - the first step begins exactly, bit for bit, at the first pose and the last one ends exactly at the last.
/// A move with a fixed axis is one step. Axes with opposite directions rotate about an arbitrary normal of them.
/// No allocation.
class PoseSteps {
public:
    /// @param reach     mm, > 0, largest distance of the relevant points from the tip: `reachOf`
    /// @param tolerance mm, > 0
    /// A pose that is not finite gives no step.
    PoseSteps(const ToolPose& from, const ToolPose& to, double reach, double tolerance) noexcept;

    std::int32_t count() const noexcept { return count_; }
    /// @param k 0 … count() - 1
    PoseStep step(std::int32_t k) const noexcept;
    /// The true motion. @param part fraction of the time, 0 … 1
    ToolPose poseAt(double part) const noexcept;

private:
    ToolPose from_, to_;
    glm::dvec3 turning_{0.0}; ///< unit, perpendicular to the first axis, towards the last
    double angle_ = 0.0;      ///< rad, between the axes
    std::int32_t count_ = 0;
};

} // namespace burin
