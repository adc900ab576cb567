// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// The time for an interval of a move, in which the speed changes from one value to another, with a greatest value
/// between.
struct RampTime {
    double seconds = 0.0;
    double peak = 0.0; ///< mm/s reached
};

/// With limited acceleration only. @param from @param to speeds at the ends, mm/s, reachable within the length
/// @param length mm, > 0 @param speed limit, mm/s @param acceleration mm/s²; infinite: no limit
RampTime trapezoid(double length, double from, double to, double speed, double acceleration) noexcept;

/// With limited jerk as well, and zero acceleration at both ends: a ramp that changes the speed by d takes d / a + a /
/// j, or 2 sqrt(d / j) if it does not reach the acceleration a. If the length is too short to get from one speed to the
/// other, it is traversed at their mean, as every ramp is. @param jerk mm/s³; infinite: trapezoid
RampTime sCurve(double length, double from, double to, double speed, double acceleration, double jerk) noexcept;

} // namespace burin
