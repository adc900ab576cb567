// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// What an interval of a move takes: its speed goes from one to another with a greatest one between.
struct RampTime {
    double seconds = 0.0;
    double peak = 0.0; ///< mm/s that is reached
};

/// With limited acceleration alone. @param from @param to mm/s at the ends, reachable within the length
/// @param length mm, > 0  @param speed mm/s, at most  @param acceleration mm/s²; infinite: without limit
RampTime trapezoid(double length, double from, double to, double speed, double acceleration) noexcept;

/// With limited jerk as well, acceleration being none at both ends: ramps that change the speed by d take d / a + a /
/// j, or 2 sqrt(d / j) where the acceleration is not reached. Where the length is too short to get from one speed to
/// the other, it is gone at their mean, as every ramp is. @param jerk mm/s³; infinite: trapezoid
RampTime sCurve(double length, double from, double to, double speed, double acceleration, double jerk) noexcept;

} // namespace burin
