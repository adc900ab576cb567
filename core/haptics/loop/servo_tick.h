// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/duration_histogram.h"
#include "core/haptics/loop/heartbeat.h"
#include "core/haptics/loop/tick_sink.h"

#include <cstdint>

namespace burin {

class HapticStep;

/// One tick of a loop, for either kind of pacing: reading, step, wrench, and once that is sent, sink and timing. A
/// wrench that comes too late for the hand is withheld here, because a step can't know how long it took.
///
/// Called on the haptic thread; no allocation, lock or system call.
class ServoTick {
public:
    /// @param period s, intended. @param byTheClock whether a hand waits for the force; false: time is simulated, and
    /// real durations have no effect. All arguments must outlive the tick.
    ServoTick(HapticStep& step, TickSink& sink, double period, bool byTheClock) noexcept;

    /// Called before a tick; returns the answer of the sink. It may be called repeatedly without a tick. While the loop
    /// stands, the gap before the next tick does not count.
    AtEdge edge() noexcept;
    /// Starts measuring the tick's work; called before its reading.
    void begin() noexcept;
    /// @param period s since the previous reading. @return the wrench that the stylus has to render
    Wrench serve(const StylusState& reading, double period) noexcept;
    /// Called once the wrench is on its way.
    void sent() noexcept;
    /// @param nanoseconds processor time of the tick, which only the kernel knows, so that it is queried outside of the
    /// tick.
    void spent(std::int64_t nanoseconds) noexcept;

    void missed(std::uint64_t edges) noexcept { timing_.missed += edges; }
    void scheduled(SchedulingClass scheduling) noexcept { timing_.scheduling = scheduling; }
    const TickTiming& timing() const noexcept { return timing_; }
    std::uint64_t ticks() const noexcept { return ticks_; }
    Heartbeat& heart() noexcept { return heart_; }

    /// Durations of all ticks so far; may only be read once no thread ticks any more.
    struct Histograms {
        DurationHistogram work, cpu, interval;
    };
    const Histograms& histograms() const noexcept { return histograms_; }

private:
    TickFault faultOf(const Sample& sample, const StylusState& reading, double period) const noexcept;

    HapticStep& step_;
    TickSink& sink_;
    const GapLimits limits_;
    const bool byTheClock_;
    Heartbeat heart_;
    Histograms histograms_;
    TickTiming timing_;
    Sample sample_;
    std::int64_t begun_ = 0, sentBefore_ = 0; ///< ns
    std::uint64_t ticks_ = 0;
    bool withheld_ = false; ///< whether the force of the last tick was withheld: the device renders none
    bool faulty_ = true;    ///< a fault is only reported after a valid tick
};

} // namespace burin
