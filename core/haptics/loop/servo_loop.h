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

/// How a loop ran. Durations in µs; of one tick: read, step, write, sink.
struct LoopStatistics {
    std::uint64_t ticks = 0;
    double simulatedSeconds = 0.0; ///< session time: sum of the periods told to the step
    double wallSeconds = 0.0;
    double rateHz = 0.0;                                                    ///< ticks over wall seconds
    double workP50 = 0.0, workP99 = 0.0, workP999 = 0.0, workMaximum = 0.0; ///< wall clock
    double cpuP50 = 0.0, cpuP999 = 0.0, cpuMaximum = 0.0;                   ///< of this thread's processor time
    double intervalP50 = 0.0, intervalP99 = 0.0, intervalP999 = 0.0, intervalMaximum = 0.0; ///< from force to force
    double latenessP50 = 0.0, latenessP999 = 0.0; ///< wake-up after the edge; realtime at our clock only
    std::uint64_t missed = 0;                     ///< edges, or the device's periods, that were skipped; realtime only
    std::uint64_t late = 0;  ///< ticks whose force was withheld, as it came too late; realtime only
    std::uint64_t cuts = 0;  ///< times that the watchdog cut the motors
    double cutSeconds = 0.0; ///< s, the longest from the loop's last beat until they were cut
    SchedulingClass scheduling = SchedulingClass::normal;
    bool memoryLocked = false; ///< stack and state of the tick can't be paged out; the workpiece can
};

/// Runs a stylus and a step until the stylus has finished, `stop` is set or the time is over: a stylus that is called
/// in the calling thread, a self-paced one in its own thread, while the caller waits. The stylus must be open; it gets
/// zero force on every way out. The step is the only thing that is called between a reading and its force. Nothing in
/// the loop allocates, locks or writes files; a full sink is met outside the step:
/// - fast, time lapse: waits for the reader;
/// - realtime: the loop ends with recordingOverflow (subject: samples handed over). No sample is lost silently.
/// Realtime, without time lapse, also: real-time scheduling where it is granted, for as long as it runs; a watchdog on
/// a second thread (LoopWatchdog) cuts the motors when the loop dies.
/// Errors: argumentInvalid (a period not > 0, ticksPerEdge < 1, a self-paced stylus at another pace than realtime),
/// recordingOverflow, those of SelfPacedStylus::start.
Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, TickSink& sink,
                                    const ServoSettings& settings, const std::atomic<bool>& stop);

/// The same with a ring for a sink.
Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, Ring<Sample>& samples,
                                    const ServoSettings& settings, const std::atomic<bool>& stop);

} // namespace burin
