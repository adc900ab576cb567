// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/speed_ramp.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Time to change the speed by `change`, s.
double rampSeconds(double change, double acceleration, double jerk) noexcept {
    if (change * jerk >= acceleration * acceleration) return change / acceleration + acceleration / jerk;
    return 2.0 * std::sqrt(change / jerk);
}

} // namespace

RampTime trapezoid(double length, double from, double to, double speed, double acceleration) noexcept {
    if (!std::isfinite(acceleration)) return {length / speed, speed};
    const double squares = from * from + to * to;
    const double peak = std::min(speed, std::sqrt(acceleration * length + 0.5 * squares));
    const double ramps = (2.0 * peak * peak - squares) / (2.0 * acceleration);
    return {(2.0 * peak - from - to) / acceleration + std::max(0.0, length - ramps) / peak, peak};
}

RampTime sCurve(double length, double from, double to, double speed, double acceleration, double jerk) noexcept {
    if (!std::isfinite(jerk)) return trapezoid(length, from, to, speed, acceleration);
    const auto seconds = [&](double peak) {
        return rampSeconds(peak - from, acceleration, jerk) + rampSeconds(peak - to, acceleration, jerk);
    };
    const auto way = [&](double peak) {
        return 0.5 * (from + peak) * rampSeconds(peak - from, acceleration, jerk) +
               0.5 * (peak + to) * rampSeconds(peak - to, acceleration, jerk);
    };
    double low = std::max(from, to), high = std::max(speed, low);
    if (way(low) >= length) return {from + to > 0.0 ? 2.0 * length / (from + to) : 0.0, low};
    if (way(high) > length) {
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (low + high);
            (way(middle) > length ? high : low) = middle;
        }
        high = low;
    }
    return {seconds(high) + std::max(0.0, length - way(high)) / high, high};
}

} // namespace burin
