// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"

#include <cstdint>

namespace burin {

/// How a tool may follow the hand in one tick.
struct ProxyStride {
    double travel = 0.0; ///< mm; the tip's way is no longer
    double turn = 0.0;   ///< rad that the axis may turn; 0: it stands
    /// What gives way where hand and boundary disagree.
    enum class Yields : std::uint8_t {
        both, ///< as the turn length weighs them
        tip,  ///< the axis follows the hand, the tip makes room for it; then the tip goes where the axis lets it
    } yields = Yields::both;
    double turnLength = 1.0; ///< mm: a turn by 1 rad counts as so much of the tip's way; > 0. Yields::both
    double room = 0.0;       ///< mm of the tip's way that the axis may claim for itself. Yields::tip
};

/// The nearest pose that the boundary allows (god-object: Zilles & Salisbury 1995; Ruspini 1997).
struct ProxyStep {
    ToolPose pose;
    bool onBoundary = false; ///< held back
    glm::dvec3 normal{0.0};  ///< of the boundary at the pose, by the tip, unit, outwards; zero when free
    bool axisHeld = false;   ///< the boundary keeps the axis from where the hand wants it
    int iterations = 0;
};

/// Moves a proxy from a feasible pose towards a goal without passing the boundary: marches in steps no longer than the
/// clearance, slides along planes solved together, never accepts an infeasible pose. Feasible means clearance >= 0.
/// The way from `from` to the answer (tip straight, axis turning evenly: PoseSteps) is feasible too, but for
/// `chordTolerance`: what is swept or written to a path between two ticks keeps to the boundary as well as the ticks
/// themselves. Lengths of ways are those of the tool's farthest point, so that a turn sweeps nothing unseen.
/// Every accepted step comes nearer to the goal, so the proxy rests where the goal rests.
/// A function of its arguments, as far as the boundary is; no allocation; the boundary's thread.
class Proxy {
public:
    static constexpr int maximumIterations = 24;
    /// mm of clearance that the proxy rests at when it is pressed against the boundary.
    static constexpr double restingGap = 1e-4;
    /// mm of clearance up to which a proxy counts as touching the boundary.
    static constexpr double contactGap = 1e-3;
    /// rad that the axis may be off the hand's without counting as held.
    static constexpr double axisTolerance = 1e-3;

    /// @param boundary outlives the object
    explicit Proxy(PoseBoundary& boundary) noexcept : boundary_(&boundary) {}

    /// @param from feasible; an infeasible one stays where it is. @param goal anywhere.
    ProxyStep advance(const ToolPose& from, const ToolPose& goal, const ProxyStride& stride) const noexcept;

    /// Moves an infeasible tool out along the clearance's gradient, its axis standing, by `maximumTravel` (mm) at most.
    /// One that gains no clearance any more (a pocket too narrow for the allowance) stays.
    ToolPose retreat(const ToolPose& from, double maximumTravel) const noexcept;

    /// Its clearance is not below 0, but for rounding (1e-9 mm).
    bool feasible(const ToolPose& pose) const noexcept;

    /// mm below 0 that the clearance may have on the way between two ticks.
    double chordTolerance() const noexcept;

private:
    PoseBoundary* boundary_;
};

} // namespace burin
