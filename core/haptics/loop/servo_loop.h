// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/ring.h"
#include "core/device/stylus_handle.h"
#include "core/haptics/loop/loop_watchdog.h"
#include "core/haptics/loop/pacing.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/recording/sample.h"

#include <atomic>
#include <cstdint>

namespace burin {

class HapticStep;

/// Statistics of a loop's run. Durations in µs; those of one tick comprise read, step, write and sink.
struct LoopStatistics {
    std::uint64_t ticks = 0;
    double simulatedSeconds = 0.0; ///< session time: sum of the periods passed to the step
    double wallSeconds = 0.0;
    double rateHz = 0.0;                                                    ///< ticks over wall seconds
    double workP50 = 0.0, workP99 = 0.0, workP999 = 0.0, workMaximum = 0.0; ///< wall clock
    double cpuP50 = 0.0, cpuP999 = 0.0, cpuMaximum = 0.0;                   ///< processor time of this thread
    /// between consecutive forces
    double intervalP50 = 0.0, intervalP99 = 0.0, intervalP999 = 0.0, intervalMaximum = 0.0;
    double latenessP50 = 0.0, latenessP999 = 0.0; ///< wake-up after the edge; only realtime with our clock
    std::uint64_t missed = 0; ///< skipped edges of the clock, or skipped periods of the device; realtime only
    std::uint64_t late = 0;   ///< ticks whose force was withheld because it came too late; realtime only
    std::uint64_t cuts = 0;   ///< how many times the watchdog cut the motors
    double cutSeconds = 0.0;  ///< s, longest time from the loop's last beat until they were cut
    SchedulingClass scheduling = SchedulingClass::normal;
    /// whether stack and state of the tick are locked in memory; the workpiece can be paged out
    bool memoryLocked = false;
};

/// Runs a stylus and a step until the stylus has finished, `stop` is set or the time is over: a stylus that is called
/// runs in the calling thread, a self-paced one in its own thread while the caller waits. The stylus must be open; it
/// gets zero force however the loop ends. The step is the only thing that is called between a reading and its force.
/// Nothing in the loop allocates, locks or writes files; a full sink is handled outside the step:
/// - fast, time lapse: the loop waits for the reader;
/// - realtime: the loop ends with recordingOverflow (subject: samples handed over). No sample is lost silently. In
///   realtime without time lapse the loop also uses real-time scheduling, if granted, while it runs, and a watchdog on
///   a second thread (LoopWatchdog) cuts the motors when the loop dies.
/// Errors: argumentInvalid (a period not > 0, ticksPerEdge < 1, a self-paced stylus at another pace than realtime),
/// recordingOverflow, those of SelfPacedStylus::start.
Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, TickSink& sink,
                                    const ServoSettings& settings, const std::atomic<bool>& stop);

/// The same with a ring as the sink.
Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, Ring<Sample>& samples,
                                    const ServoSettings& settings, const std::atomic<bool>& stop);

} // namespace burin
