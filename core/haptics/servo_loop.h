// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/ring.h"
#include "core/device/stylus.h"
#include "core/haptics/tick_sink.h"
#include "core/recording/sample.h"

#include <atomic>
#include <cstdint>
#include <limits>

namespace burin {

class HapticStep;

enum class Pace : std::uint8_t {
    realtime, ///< a tick at each edge of the monotonic clock; an overrun skips to the next edge
    fast,     ///< as fast as possible, time is simulated: `period` a tick
};

struct ServoSettings {
    double period = 0.001; ///< s
    Pace pace = Pace::realtime;
    double maximumSeconds = std::numeric_limits<double>::infinity(); ///< of the session's time, simulated when fast
    /// Realtime: time lapse with so many ticks at each edge, each told the nominal period. For styluses whose hand is
    /// simulated. Such a loop waits for a full sink.
    int ticksPerEdge = 1;
};

/// How a loop ran. Durations in µs; of one tick: read, step, write, sink.
struct LoopStatistics {
    std::uint64_t ticks = 0;
    double simulatedSeconds = 0.0; ///< session time: sum of the periods told to the step
    double wallSeconds = 0.0;
    double rateHz = 0.0;                                                    ///< ticks over wall seconds
    double workP50 = 0.0, workP99 = 0.0, workP999 = 0.0, workMaximum = 0.0; ///< wall clock
    double cpuP50 = 0.0, cpuP999 = 0.0;                                     ///< of this thread's processor time
    double latenessP50 = 0.0, latenessP999 = 0.0;                           ///< wake-up after the edge; realtime only
    std::uint64_t missed = 0;                                               ///< edges that were skipped; realtime only
    SchedulingClass scheduling = SchedulingClass::normal;
};

/// Runs a stylus and a step in the calling thread until the stylus has finished, `stop` is set or the time is over.
/// The stylus must be open; it gets zero force on every way out. The step is the only thing that is called between a
/// reading and its force. Nothing in the loop allocates, locks or writes files; a full sink is met outside the step:
/// - fast, time lapse: waits for the reader;
/// - realtime: the loop ends with recordingOverflow (subject: samples handed over). No sample is lost silently.
/// Realtime tries SCHED_FIFO within the limits in force and puts the thread back afterwards.
/// Errors: argumentInvalid (a period not > 0, ticksPerEdge < 1), recordingOverflow.
Result<LoopStatistics> runServoLoop(Stylus& stylus, HapticStep& step, TickSink& sink, const ServoSettings& settings,
                                    const std::atomic<bool>& stop);

/// The same with a ring for a sink.
Result<LoopStatistics> runServoLoop(Stylus& stylus, HapticStep& step, Ring<Sample>& samples,
                                    const ServoSettings& settings, const std::atomic<bool>& stop);

} // namespace burin
