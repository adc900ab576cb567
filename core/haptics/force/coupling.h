// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_settings.h"

namespace burin {

/// Gains of the virtual coupling in device space.
struct CouplingGains {
    double stiffness = 0.0;      ///< N/m
    double damping = 0.0;        ///< N·s/m
    double restingDamping = 0.0; ///< N·s/m, for a hand at rest, whose velocity consists mostly of encoder steps
};

/// The damping on the hand that can be used, N·s/m: the stylus' value, but no more than a light handle of 0.1 kg allows
/// with the delay of a tick (a velocity is half a tick old when it is known, its force is held for a whole one) and of
/// the device. A damper that acts too late drives instead of damping. @param period s
double usableDamping(const StylusDescription& stylus, double period) noexcept;

/// The same for a lag, s > 0, from the motion of a handle to the end of the damper's answer. @param most N·s/m
/// @param mass of the handle, kg
double usableDamping(double most, double mass, double lag) noexcept;

/// The damping, N·s/m, by which a sampled and held spring reduces a handle's own damping: K (T/2 + delay) (Colgate &
/// Schenkel 1994; with delay: Gil, Hulin and others). @param stiffness N/m
double sampledSpringLoss(double stiffness, double period, double delay) noexcept;

/// Gains from the values of the stylus, which hold for 1 kHz without delay: the stiffness that stays passive is
/// inversely proportional to the sum of half the period and the delay, and is not raised above `share` of the stylus'
/// value for faster loops. Damping: 0.3 of the device's, as more helps stability but costs passivity; at rest no more
/// than 0.6 of the damping that the spring takes. Zero for a stylus without motors.
/// @param limits lower the result, whatever the share
CouplingGains couplingGains(const StylusDescription& stylus, double share, double period,
                            const GainLimits& limits = {}) noexcept;

/// Of the spring at the boundary, in a session.
CouplingGains boundaryGains(const HapticSettings& settings) noexcept;
/// Of the springs of the guides: limits leave their proportion to that at the boundary.
CouplingGains guideGains(const HapticSettings& settings) noexcept;

inline constexpr double ratedPeriod = 0.001; ///< s, for which a stylus states its stiffness
inline constexpr double dampingShare = 0.3;  ///< of the usable damping, for the coupling
inline constexpr double lightHandle = 0.1;   ///< kg, of a stylus that nobody holds; our estimate

/// The only spring that the hand feels at the boundary, between the hand and the proxy. It acts in device space
/// (Colgate 1995; Adams & Hannaford 1999), so that its stiffness does not depend on the scale of the workspace.
class Coupling {
public:
    /// @param scale mm of setup per mm of device
    Coupling(CouplingGains gains, double scale) noexcept : gains_(gains), scale_(scale) {}

    /// The state that the force depends on. All in the setup frame.
    struct State {
        glm::dvec3 proxy{0.0}, hand{0.0};                 ///< mm
        glm::dvec3 proxyVelocity{0.0}, handVelocity{0.0}; ///< mm/s
        glm::dvec3 normal{0.0}; ///< unit, of the surface that holds the proxy; zero when free: no damping then
        bool rests = false;     ///< whether the hand is at rest
    };
    /// Force in N, axes of the setup frame, magnitude as in device space.
    glm::dvec3 force(const State& state) const noexcept;
    /// The same for the displacement of the spring, mm, and the speed that the damper acts on, mm/s.
    /// @param rests as in State
    glm::dvec3 force(const glm::dvec3& pull, const glm::dvec3& speed, bool rests) const noexcept;

    void setScale(double scale) noexcept { scale_ = scale; } ///< mm of setup per mm of device
    double stiffness() const noexcept { return gains_.stiffness; }

private:
    CouplingGains gains_;
    double scale_;
};

} // namespace burin
