// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/duration_histogram.h"
#include "core/haptics/loop/heartbeat.h"
#include "core/haptics/loop/tick_sink.h"

#include <cstdint>

namespace burin {

class HapticStep;

/// One tick of a loop, whoever keeps its time: reading, step, wrench, and once that is sent, sink and timing. A wrench
/// that comes too late for the hand is withheld here: a step can't know how long it took.
///
/// The thread that ticks; no allocation, lock or system call.
class ServoTick {
public:
    /// @param period s, intended. @param byTheClock a hand waits for the force; false: time is simulated, and how long
    /// anything takes changes nothing. What is given must outlive the tick.
    ServoTick(HapticStep& step, TickSink& sink, double period, bool byTheClock) noexcept;

    /// Before a tick: what the sink says; it alone may be asked again without a tick. Standing, the next tick's gap
    /// doesn't count.
    AtEdge edge() noexcept;
    /// From here on the tick's work counts: before its reading.
    void begin() noexcept;
    /// @param period s since the reading before. @return what the stylus shall render
    Wrench serve(const StylusState& reading, double period) noexcept;
    /// Once the wrench is on its way.
    void sent() noexcept;
    /// @param nanoseconds of processor time that the tick took, which only the kernel knows: asked for outside of it.
    void spent(std::int64_t nanoseconds) noexcept;

    void missed(std::uint64_t edges) noexcept { timing_.missed += edges; }
    void scheduled(SchedulingClass scheduling) noexcept { timing_.scheduling = scheduling; }
    const TickTiming& timing() const noexcept { return timing_; }
    std::uint64_t ticks() const noexcept { return ticks_; }
    Heartbeat& heart() noexcept { return heart_; }

    /// Durations of all ticks so far; only once no thread ticks any more.
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
    bool withheld_ = false; ///< the force of the last tick: the device holds none
    bool faulty_ = true;    ///< what was never well does not break
};

} // namespace burin
