// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/viewport.h"

#include <chrono>
#include <optional>
#include <vector>

namespace burin {

/// Records the times of the newest paints and cuts.
class FrameClock {
public:
    using Clock = std::chrono::steady_clock;

    /// @param cut time of the oldest cut that this paint is the first to show
    void add(Clock::time_point begin, Clock::time_point end, std::optional<Clock::time_point> cut);
    void reset();
    /// The timings; the owner adds the values about what is drawn.
    FrameStatistics statistics() const;

private:
    /// The newest durations, ms, with the count and maximum of all durations.
    struct Durations {
        static constexpr std::size_t kept = 4096;
        std::vector<double> newest;
        std::size_t count = 0;
        double maximum = 0.0;
        void add(Clock::duration duration);
        double percentile95() const;
    };
    Durations paints_, cuts_;
};

} // namespace burin
