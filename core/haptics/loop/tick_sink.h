// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ring.h"
#include "core/device/stylus.h"
#include "core/haptics/loop/tick_fault.h"
#include "core/recording/sample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// The scheduling class that the system granted the loop's thread, in ascending order.
enum class SchedulingClass : std::uint8_t {
    normal,
    nice,       ///< the normal class with a negative nice value, granted by RealtimeKit
    roundRobin, ///< SCHED_RR, granted by RealtimeKit
    fifo,       ///< SCHED_FIFO, allowed by the limits in force
};

/// The name as used in the JSON of the command line.
constexpr std::string_view nameOf(SchedulingClass scheduling) noexcept {
    constexpr std::array<std::string_view, 4> names{"normal", "nice", "round-robin", "fifo"};
    return names[static_cast<std::size_t>(scheduling)];
}

/// Timing of the loop, reported with each tick. Times in ns.
struct TickTiming {
    double period = 0.0;            ///< s, passed to the step
    std::int64_t over = 0;          ///< CLOCK_MONOTONIC, time at which the force was sent
    std::int64_t interval = 0;      ///< from the previous force to this one; 0: first tick, or the loop stood
    std::int64_t work = 0, cpu = 0; ///< of the previous tick in total: wall clock, processor time of the thread
    std::uint64_t missed = 0;       ///< edges skipped since the loop began
    std::uint64_t late = 0;         ///< ticks since the loop began whose force was withheld because it came too late
    SchedulingClass scheduling = SchedulingClass::normal;
    TickFault fault = TickFault::none; ///< fault that begins with this tick
    StylusState reading;               ///< as returned by the stylus
};

/// What a loop has to do at an edge of its clock.
enum class AtEdge : std::uint8_t {
    tick,  ///< run a tick
    stand, ///< no tick: zero force, and the next edge asks again; edges passed in this state do not count as missed
    /// the sink has no room for the next tick: the loop waits if possible, otherwise it ends with recordingOverflow
    full,
};

/// Receives the ticks of a loop. Called only by the thread that runs the ticks; without allocation, lock or file
/// access.
class TickSink {
public:
    virtual ~TickSink() = default;
    /// Called between two ticks: here, and only here, other code may change the workpiece and the step.
    virtual AtEdge edge() noexcept = 0;
    /// Called after the force was sent, so that the hand never waits for it.
    virtual void tick(const Sample& sample, const TickTiming& timing) noexcept = 0;
};

/// Puts every tick into a ring; the loop handles a full ring.
class RingSink final : public TickSink {
public:
    explicit RingSink(Ring<Sample>& ring) noexcept : ring_(ring) {}
    AtEdge edge() noexcept override { return ring_.size() < ring_.capacity() ? AtEdge::tick : AtEdge::full; }
    void tick(const Sample& sample, const TickTiming&) noexcept override { ring_.push(sample); }

private:
    Ring<Sample>& ring_;
};

} // namespace burin
