// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/frame_clock.h"

#include <algorithm>

namespace burin {

void FrameClock::Durations::add(Clock::duration duration) {
    const double milliseconds = std::chrono::duration<double, std::milli>(duration).count();
    if (newest.size() < kept)
        newest.push_back(milliseconds);
    else
        newest[count % kept] = milliseconds;
    ++count;
    maximum = std::max(maximum, milliseconds);
}

double FrameClock::Durations::percentile95() const {
    if (newest.empty()) return 0.0;
    std::vector<double> sorted = newest;
    // The smallest value that is not exceeded by 95 % of all values.
    const std::size_t rank = (95 * sorted.size() + 99) / 100 - 1;
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(rank));
    return sorted[rank];
}

void FrameClock::add(Clock::time_point begin, Clock::time_point end, std::optional<Clock::time_point> cut) {
    paints_.add(end - begin);
    if (cut) cuts_.add(end - *cut);
}

void FrameClock::reset() {
    paints_ = {};
    cuts_ = {};
}

FrameStatistics FrameClock::statistics() const {
    FrameStatistics result;
    result.frames = paints_.count;
    result.paintMaximum = paints_.maximum;
    result.paintP95 = paints_.percentile95();
    result.cutToScreenP95 = cuts_.percentile95();
    result.cutToScreenMaximum = cuts_.maximum;
    result.cutsShown = cuts_.count;
    return result;
}

} // namespace burin
