// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/haptics/force/plastic_anchor.h"

namespace burin {

/// How cutting and sliding come into the hand. A force against the velocity would be a damper far beyond what a desktop
/// device can hold; here a plastic anchor yields at
///     scale · 1000 K A (and of Kr K A what points against the motion) + friction · normal load,
/// A the area that meets the material, K that of this tick's mix of materials: the area is smooth already, so the force
/// is; a change of material is in K at once. It goes with neither the hand's speed nor, at rest, with time. What is
/// left of the radial part pushes the tool aside while it moves, and no longer than that.
///
/// A step of an encoder is a step of the spring. Where the device's is known, what the spring sees is smoothed, in time
/// and no longer than 5 ms, so that a step shows as 0.004 N a tick; a change of material is not, as it is no motion.
/// Tick code.
class CuttingForceRendering {
public:
    struct Settings {
        double gain = 1.0;           ///< the user's: 1 makes the reference cut `referenceShare` of the maximum
        double stiffness = 0.0;      ///< N/m in device space, at most the coupling's
        double maximum = 0.0;        ///< N, of what is rendered
        double friction = 0.0;       ///< Coulomb's coefficient of flutes or shank that slide on what they don't cut
        double workspaceScale = 1.0; ///< mm of setup per mm of device
        double positionStep = 0.0;   ///< mm, device space: what the device resolves
    };
    static constexpr double referenceShare = 0.6; ///< of the maximum, that the hardest material's reference cut gets

    explicit CuttingForceRendering(const Settings& settings) noexcept;

    /// What a tick renders from.
    struct Tick {
        glm::dvec3 motion{0.0};   ///< mm, of the tip in this tick, setup frame
        glm::dvec3 velocity{0.0}; ///< mm/s, of the tip over the last ticks
        glm::dvec3 normal{0.0};   ///< unit, of what the tool slides on; zero: of nothing
        double load = 0.0;        ///< N that presses the tool against what it slides on, as the device renders it
        double period = 0.001;    ///< s
    };
    /// @return N, axes of the setup frame, at most `maximum`
    glm::dvec3 render(const CuttingForce& cut, const Tick& tick) noexcept;
    /// As before the first tick; the workspace's scale stays.
    void reset() noexcept;
    /// From the next tick on; the anchor gets the stiffness that belongs to it.
    /// @param scale mm of setup per mm of device
    void setWorkspaceScale(double scale) noexcept;

    /// Rendered over 1000 K A; 0 where nothing has a K.
    double scale(const CuttingForce& cut) const noexcept;

private:
    void followDirections(const CuttingForce& cut, const Tick& tick) noexcept;
    double stepSmoothing() const noexcept;

    Settings settings_;
    PlasticAnchor anchor_;
    double smoothing_;                        ///< s, of the steps of an encoder
    glm::dvec3 behind_{0.0};                  ///< mm, by which the anchor's tool lags the tool
    double area_ = 0.0;                       ///< mm²
    glm::dvec3 heading_{0.0};                 ///< of the motion, smoothed over the way; not longer than 1
    glm::dvec3 away_{0.0};                    ///< Kr times the direction from the material, smoothed over the way
    double startsMoving_ = 0.0, moves_ = 0.0; ///< 0 … 1: a filter of first order behind another
};

/// What of the cutting force there is room for beside what holds the tool: the largest share of it with which both stay
/// within the maximum; where none does, the one with which they come nearest. Direction kept, continuous.
/// @param held, cutting N. @param maximum N, >= 0
glm::dvec3 besideHeld(const glm::dvec3& held, const glm::dvec3& cutting, double maximum) noexcept;

} // namespace burin
