// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/servo_tick.h"

#include <atomic>
#include <cstdint>
#include <limits>

namespace burin {

enum class Pace : std::uint8_t {
    realtime, ///< a tick at each edge of the monotonic clock; an overrun skips to the next edge
    fast,     ///< as fast as possible, time is simulated: `period` a tick
};

class LoopAlarm;

struct ServoSettings {
    double period = 0.001; ///< s; of a self-paced stylus: what its own rate makes
    Pace pace = Pace::realtime;
    double maximumSeconds = std::numeric_limits<double>::infinity(); ///< of the session's time, simulated when fast
    /// Realtime: time lapse with so many ticks at each edge, each told the nominal period. For styluses whose hand is
    /// simulated. Such a loop waits for a full sink.
    int ticksPerEdge = 1;
    LoopAlarm* alarm = nullptr; ///< hears, on the watchdog's thread, when the loop died; outlives the loop
};

/// What keeps the time of a loop's ticks. Two kinds: edges of our clock, at which the stylus is called, and the stylus'
/// own readings, at which it calls us. Both make the same ServoTick.
struct PacingOutcome {
    bool overflow = false;
    double time = 0.0; ///< s of the session
    DurationHistogram lateness;
    bool memoryLocked = false;
};

/// At edges of our clock, in the calling thread, until the stylus has finished, `stop` is set or the time is over.
void paceByClock(Stylus& stylus, ServoTick& tick, const ServoSettings& settings, const std::atomic<bool>& stop,
                 PacingOutcome& outcome) noexcept;

/// At the stylus' own readings, in its thread; the calling thread waits. Errors: those of SelfPacedStylus::start.
Result<void> paceByDevice(SelfPacedStylus& stylus, ServoTick& tick, const ServoSettings& settings,
                          const std::atomic<bool>& stop, PacingOutcome& outcome);

} // namespace burin
