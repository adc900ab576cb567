// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

namespace burin {

/// Gains of the virtual coupling in device space.
struct CouplingGains {
    double stiffness = 0.0;      ///< N/m
    double damping = 0.0;        ///< N·s/m
    double restingDamping = 0.0; ///< N·s/m, of a hand at rest, whose velocity is mostly its encoders' steps
};

/// N·s/m that a damper on the hand may have: the stylus' figure, but no more than what a light handle of 0.1 kg bears
/// with the lag of a tick (a velocity is half a tick old when it is known, its force holds for a whole one) and of the
/// device. A damper that comes too late drives instead of damping. @param period s
double usableDamping(const StylusDescription& stylus, double period) noexcept;

/// N·s/m that a spring, sampled and held, takes from a handle's own damping: K (T/2 + delay) (Colgate & Schenkel 1994;
/// with delay: Gil, Hulin and others). @param stiffness N/m
double sampledSpringLoss(double stiffness, double period, double delay) noexcept;

/// From the stylus' own figures, which hold for 1 kHz without delay: the stiffness that stays passive goes with one
/// over half the period and the delay, and is not raised above `share` of the figure for faster loops. Damping: 0.3
/// of the device's, as more helps stability but costs passivity; at rest no more than 0.6 of what the spring takes.
/// Zero for a stylus without motors.
CouplingGains couplingGains(const StylusDescription& stylus, double share, double period) noexcept;

/// The only spring that the hand feels at the boundary: between the hand and the proxy, in device space (Colgate 1995;
/// Adams & Hannaford 1999), so that its stiffness does not depend on the scale of the workspace.
class Coupling {
public:
    /// @param scale mm of setup per mm of device
    Coupling(CouplingGains gains, double scale) noexcept : gains_(gains), scale_(scale) {}

    /// What is felt of the distance between hand and proxy. All in the setup frame.
    struct State {
        glm::dvec3 proxy{0.0}, hand{0.0};                 ///< mm
        glm::dvec3 proxyVelocity{0.0}, handVelocity{0.0}; ///< mm/s
        glm::dvec3 normal{0.0}; ///< unit, of what holds the proxy; zero when free: no damping then
        bool rests = false;     ///< the hand
    };
    /// N, axes of the setup frame, magnitude as in device space.
    glm::dvec3 force(const State& state) const noexcept;
    /// The same of a way that the spring pulls over, mm, and a speed that the damper brakes, mm/s.
    /// @param rests as in State
    glm::dvec3 force(const glm::dvec3& pull, const glm::dvec3& speed, bool rests) const noexcept;

    void setScale(double scale) noexcept { scale_ = scale; } ///< mm of setup per mm of device
    double stiffness() const noexcept { return gains_.stiffness; }

private:
    CouplingGains gains_;
    double scale_;
};

} // namespace burin
