// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace burin {

struct LineValue {
    double value = 0.0;
    double slope = 0.0; ///< a subgradient
};

struct LineMinimum {
    double place = 0.0;
    double value = 0.0;
};

/// The minimum of a convex function between two positions, exact to `tolerance`. Two tangents give a lower bound where
/// they meet, which decides both when to stop and, compared with `cutoff`, when continuing is pointless: the result is
/// then some value that is not below `cutoff`. Alternates between the zero of the slopes' secant (fast where the
/// function is smooth) and the meeting point of the tangents (finite on kinks).
template <class Function>
LineMinimum minimumOnLine(const Function& function, double low, double high, double cutoff, double tolerance) {
    LineValue atLow = function(low);
    if (atLow.slope >= 0.0) return {low, atLow.value};
    LineValue atHigh = function(high);
    if (atHigh.slope <= 0.0) return {high, atHigh.value};

    for (int step = 0; step < 100; ++step) {
        const LineMinimum least =
            atLow.value <= atHigh.value ? LineMinimum{low, atLow.value} : LineMinimum{high, atHigh.value};
        const double width = high - low, bend = atHigh.slope - atLow.slope;
        const double meeting = std::clamp((atLow.value - atHigh.value + atHigh.slope * width) / bend, 0.0, width);
        const double bound = atLow.value + atLow.slope * meeting;
        if (bound >= cutoff || least.value - bound <= tolerance) return least;

        double next = low + (step % 2 == 0 ? -atLow.slope * width / bend : meeting);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (!(next > low && next < high)) return least;
        const LineValue there = function(next);
        if (there.slope < 0.0) {
            low = next;
            atLow = there;
        } else if (there.slope > 0.0) {
            high = next;
            atHigh = there;
        } else {
            return {next, there.value};
        }
    }
    return atLow.value <= atHigh.value ? LineMinimum{low, atLow.value} : LineMinimum{high, atHigh.value};
}

} // namespace burin
