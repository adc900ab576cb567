// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/duration_histogram.h"
#include "core/haptics/loop/tick_sink.h"

#include <array>
#include <cstdint>

namespace burin {

/// Current timing statistics of a running loop.
struct LiveFigures {
    double rateHz = 0.0;                  ///< ticks per second of wall time, over the last second
    double cpuP999 = 0.0, workP999 = 0.0; ///< µs per tick, since the loop began
    double intervalP999 = 0.0;            ///< µs between consecutive forces, since the loop began
    std::uint64_t ticks = 0, missed = 0, late = 0;
    SchedulingClass scheduling = SchedulingClass::normal;
};

/// Computes the statistics of a running loop in fixed memory. Adding takes a few instructions; four times per second of
/// wall time the quantiles are computed, which takes some µs after a force was sent. Haptic thread.
class LoopFigures {
public:
    /// Returns true when there are new statistics.
    bool add(const TickTiming& timing) noexcept;
    const LiveFigures& newest() const noexcept { return figures_; }

private:
    static constexpr std::int64_t interval = 250'000'000; ///< ns
    static constexpr std::size_t marks = 4; ///< number of intervals in the second over which the rate is computed
    struct Mark {
        std::int64_t when = 0;
        std::uint64_t ticks = 0;
    };
    DurationHistogram work_, cpu_, interval_;
    std::array<Mark, marks> marks_{}; ///< the oldest is at next_ % marks
    std::size_t next_ = 0;
    std::uint64_t ticks_ = 0;
    std::int64_t due_ = 0;
    LiveFigures figures_;
};

} // namespace burin
