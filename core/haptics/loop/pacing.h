// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/servo_tick.h"

#include <atomic>
#include <cstdint>
#include <limits>

namespace burin {

enum class Pace : std::uint8_t {
    realtime, ///< a tick at each edge of the monotonic clock; after an overrun the next tick is at the next edge
    fast,     ///< as fast as possible with simulated time: `period` per tick
};

class LoopAlarm;

struct ServoSettings {
    double period = 0.001; ///< s; for a self-paced stylus the period of its own rate
    Pace pace = Pace::realtime;
    /// of the session's time; simulated time with Pace::fast
    double maximumSeconds = std::numeric_limits<double>::infinity();
    /// Realtime: time lapse with this number of ticks at each edge, each with the nominal period. For styluses whose
    /// hand is simulated. Such a loop waits for a full sink.
    int ticksPerEdge = 1;
    LoopAlarm* alarm = nullptr; ///< notified on the watchdog's thread when the loop died; outlives the loop
};

/// The outcome of pacing a loop, i.e. of timing its ticks. There are two kinds of pacing: by the edges of our clock, at
/// which the stylus is called, and by the stylus' own readings, at which it calls us. Both drive the same ServoTick.
struct PacingOutcome {
    bool overflow = false;
    double time = 0.0; ///< s, session time
    DurationHistogram lateness;
    bool memoryLocked = false;
};

/// Runs ticks at the edges of our clock, in the calling thread, until the stylus has finished, `stop` is set or the
/// time is over.
void paceByClock(Stylus& stylus, ServoTick& tick, const ServoSettings& settings, const std::atomic<bool>& stop,
                 PacingOutcome& outcome) noexcept;

/// Runs ticks at the stylus' own readings, in its thread, while the calling thread waits. Errors: those of
/// SelfPacedStylus::start.
Result<void> paceByDevice(SelfPacedStylus& stylus, ServoTick& tick, const ServoSettings& settings,
                          const std::atomic<bool>& stop, PacingOutcome& outcome);

} // namespace burin
