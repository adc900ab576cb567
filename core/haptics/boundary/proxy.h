// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"

#include <cstdint>

namespace burin {

/// Limits on how a tool may follow the hand in one tick.
struct ProxyStride {
    double travel = 0.0; ///< mm, maximum length of the tip's motion
    double turn = 0.0;   ///< rad, maximum rotation of the axis; 0: the axis is fixed
    /// Which of tip and axis gives way if the boundary does not allow the hand's pose.
    enum class Yields : std::uint8_t {
        both, ///< both, weighted by the turn length
        tip, ///< the axis follows the hand and the tip makes room for it; then the tip moves as far as the axis lets it
    } yields = Yields::both;
    double turnLength = 1.0; ///< mm: a rotation by 1 rad counts as this much motion of the tip; > 0. Yields::both
    double room = 0.0;       ///< mm of tip motion that may be used to make room for the axis. Yields::tip
};

/// The pose nearest to the goal that the boundary allows (god-object: Zilles & Salisbury 1995; Ruspini 1997).
struct ProxyStep {
    ToolPose pose;
    bool onBoundary = false; ///< whether the boundary holds the tool back
    glm::dvec3 normal{0.0};  ///< of the boundary at the pose with respect to the tip, unit, outwards; zero when free
    bool axisHeld = false;   ///< the boundary keeps the axis from the hand's direction
    int iterations = 0;
};

/// Moves a proxy from a feasible pose towards a goal without passing the boundary: marches in steps no longer than the
/// clearance, slides along planes solved together, never accepts an infeasible pose. Feasible means clearance >= 0.
/// The motion from `from` to the result (tip straight, axis rotating uniformly: PoseSteps) is feasible too, except for
/// `chordTolerance`: the volume swept, or the path written, between two ticks keeps to the boundary as well as the
/// ticks themselves. Lengths of motions are those of the tool's farthest point, so that nothing swept by a rotation is
/// missed.
/// Every accepted step comes nearer to the goal, so the proxy comes to rest when the goal does.
/// The result depends only on the arguments and on the boundary. No allocation; called on the boundary's thread.
class Proxy {
public:
    static constexpr int maximumIterations = 24;
    /// Clearance, mm, of a proxy that is pressed against the boundary.
    static constexpr double restingGap = 1e-4;
    /// Clearance, mm, up to which a proxy counts as touching the boundary.
    static constexpr double contactGap = 1e-3;
    /// Deviation of the axis from the hand's, rad, up to which it does not count as held.
    static constexpr double axisTolerance = 1e-3;

    /// @param boundary outlives the object
    explicit Proxy(PoseBoundary& boundary) noexcept : boundary_(&boundary) {}

    /// @param from feasible; an infeasible pose is returned unchanged. @param goal any pose.
    ProxyStep advance(const ToolPose& from, const ToolPose& goal, const ProxyStride& stride) const noexcept;

    /// Moves an infeasible tool out along the gradient of the clearance, with its axis fixed, by `maximumTravel` (mm)
    /// at most. It stops where no clearance can be gained any more (a pocket too narrow for the allowance).
    ToolPose retreat(const ToolPose& from, double maximumTravel) const noexcept;

    /// Whether the clearance is not below 0, except for rounding errors (1e-9 mm).
    bool feasible(const ToolPose& pose) const noexcept;

    /// By how much the clearance may be below 0 between two ticks, mm.
    double chordTolerance() const noexcept;

private:
    PoseBoundary* boundary_;
};

} // namespace burin
