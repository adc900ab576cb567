// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/duration_histogram.h"
#include "core/haptics/loop/tick_sink.h"

#include <array>
#include <cstdint>

namespace burin {

/// How a loop is doing, while it runs.
struct LiveFigures {
    double rateHz = 0.0;                  ///< ticks over wall seconds, the last second
    double cpuP999 = 0.0, workP999 = 0.0; ///< µs a tick, since the loop began
    double intervalP999 = 0.0;            ///< µs from force to force, since the loop began
    std::uint64_t ticks = 0, missed = 0, late = 0;
    SchedulingClass scheduling = SchedulingClass::normal;
};

/// Keeps the figures of a running loop in fixed memory. Adding is some instructions; four times a second of wall time
/// the quantiles are worked out, which takes some µs after a force was sent. Loop's thread.
class LoopFigures {
public:
    /// True when there are new figures.
    bool add(const TickTiming& timing) noexcept;
    const LiveFigures& newest() const noexcept { return figures_; }

private:
    static constexpr std::int64_t interval = 250'000'000; ///< ns
    static constexpr std::size_t marks = 4;               ///< intervals in the second that the rate is of
    struct Mark {
        std::int64_t when = 0;
        std::uint64_t ticks = 0;
    };
    DurationHistogram work_, cpu_, interval_;
    std::array<Mark, marks> marks_{}; ///< the oldest at next_ % marks
    std::size_t next_ = 0;
    std::uint64_t ticks_ = 0;
    std::int64_t due_ = 0;
    LiveFigures figures_;
};

} // namespace burin
