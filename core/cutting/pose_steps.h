// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"

#include <cstdint>
#include <span>

namespace burin {

/// A straight move of a tool whose axis stands.
struct PoseStep {
    glm::dvec3 fromTip{0.0}, toTip{0.0}; ///< mm
    glm::dvec3 axis{0.0, 0.0, 1.0};      ///< unit length
};

/// Distance of the farthest point of a tool's pieces from its tip, mm.
double reachOf(std::span<const RevolvedPiece> pieces) noexcept;

/// A change of a tool's pose, split into straight steps with a standing axis. The true motion takes the tip straight
/// and evenly and turns the axis evenly about the normal of its two ends (the paper's interpolation, eqs. 6 and 7, with
/// the turn about the tool's own axis left out, which no cutter of revolution feels). Step k has the axis that the
/// true motion has at k / (count - 1) and stands for the time around it, so that
/// - no point of the tool within `reach` of the tip is ever farther than `tolerance` from where the true motion has it
///   (the paper asks for less than a voxel, eq. 8),
/// - the steps join: each begins at the tip that the one before it ended at,
/// - the first step begins at the first pose and the last one ends at the last, to the last bit.
/// A move whose axis stands is one step. Axes that point opposite ways turn about some normal of them.
/// No allocation.
class PoseSteps {
public:
    /// @param reach     mm, > 0, of the points that count, from the tip: `reachOf`
    /// @param tolerance mm, > 0
    /// A pose that is not finite gives no step.
    PoseSteps(const ToolPose& from, const ToolPose& to, double reach, double tolerance) noexcept;

    std::int32_t count() const noexcept { return count_; }
    /// @param k 0 … count() - 1
    PoseStep step(std::int32_t k) const noexcept;
    /// The true motion. @param part of the time, 0 … 1
    ToolPose poseAt(double part) const noexcept;

private:
    ToolPose from_, to_;
    glm::dvec3 turning_{0.0}; ///< unit, square to the first axis, towards the last
    double angle_ = 0.0;      ///< rad, between the axes
    std::int32_t count_ = 0;
};

} // namespace burin
