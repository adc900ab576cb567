// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/haptics/force/plastic_anchor.h"

namespace burin {

/// Renders the forces of cutting and sliding. A force opposed to the velocity would be a damper far beyond what a
/// desktop device can render; here a plastic anchor yields at
///     scale · 1000 K A (plus the component of Kr K A opposed to the motion) + friction · normal load,
/// A is the engaged area, K the coefficient of this tick's mix of materials: the area is smooth already, and so is the
/// force; a change of material changes K at once. The force depends neither on the hand's speed nor, at rest, on time.
/// The remaining radial component pushes the tool aside only while it moves.
///
/// A step of an encoder causes a step of the spring force. If the device's step is known, the motion seen by the spring
/// is smoothed over time, by no more than 5 ms, so that an encoder step changes the force by 0.004 N per tick. A change
/// of material is not smoothed, as it is not a motion. Called in the haptic tick.
class CuttingForceRendering {
public:
    struct Settings {
        double gain = 1.0;      ///< chosen by the user: with 1 the reference cut gives `referenceShare` of the maximum
        double stiffness = 0.0; ///< N/m in device space, at most the coupling's
        double maximum = 0.0;   ///< N, of the rendered force
        double friction = 0.0;  ///< Coulomb friction coefficient of flutes or shank sliding on what they don't cut
        double workspaceScale = 1.0; ///< mm of setup per mm of device
        double positionStep = 0.0;   ///< mm, device space: resolution of the device
    };
    /// share of the maximum force that a reference cut in the hardest material gives
    static constexpr double referenceShare = 0.6;

    explicit CuttingForceRendering(const Settings& settings) noexcept;

    /// The inputs of one tick.
    struct Tick {
        glm::dvec3 motion{0.0};   ///< mm, of the tip in this tick, setup frame
        glm::dvec3 velocity{0.0}; ///< mm/s, of the tip over the last ticks
        glm::dvec3 normal{0.0};   ///< unit, of the surface that the tool slides on; zero: none
        double load = 0.0;        ///< N, force that presses the tool against that surface, as the device renders it
        double period = 0.001;    ///< s
    };
    /// @return N, axes of the setup frame, at most `maximum`
    glm::dvec3 render(const CuttingForce& cut, const Tick& tick) noexcept;
    /// Returns to the state before the first tick; the workspace's scale is kept.
    void reset() noexcept;
    /// Takes effect with the next tick; the anchor gets the corresponding stiffness.
    /// @param scale mm of setup per mm of device
    void setWorkspaceScale(double scale) noexcept;

    /// Ratio of the rendered force to 1000 K A; 0 if no material has a K.
    double scale(const CuttingForce& cut) const noexcept;

private:
    void followDirections(const CuttingForce& cut, const Tick& tick) noexcept;
    double stepSmoothing() const noexcept;

    Settings settings_;
    PlasticAnchor anchor_;
    double smoothing_;        ///< s, for the steps of an encoder
    glm::dvec3 behind_{0.0};  ///< mm, by which the anchor's (smoothed) tool position lags behind the tool
    double area_ = 0.0;       ///< mm²
    glm::dvec3 heading_{0.0}; ///< direction of motion, smoothed over distance; not longer than 1
    glm::dvec3 away_{0.0};    ///< Kr times the direction away from the material, smoothed over distance
    double startsMoving_ = 0.0, moves_ = 0.0; ///< 0 … 1: two first-order filters in series
};

/// The share of the cutting force that fits within the maximum together with the force that holds the tool: the largest
/// share for which their sum stays within the maximum; if there is none, the share for which the sum comes nearest to
/// it. The direction is kept; the result is continuous.
/// @param held, cutting N. @param maximum N, >= 0
glm::dvec3 besideHeld(const glm::dvec3& held, const glm::dvec3& cutting, double maximum) noexcept;

} // namespace burin
