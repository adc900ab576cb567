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

/// What the system granted the loop's thread, from the least on.
enum class SchedulingClass : std::uint8_t {
    normal,
    nice,       ///< the normal class with a negative nice value, by RealtimeKit
    roundRobin, ///< SCHED_RR, by RealtimeKit
    fifo,       ///< SCHED_FIFO, by the limits in force
};

/// As in the JSON of the command line.
constexpr std::string_view nameOf(SchedulingClass scheduling) noexcept {
    constexpr std::array<std::string_view, 4> names{"normal", "nice", "round-robin", "fifo"};
    return names[static_cast<std::size_t>(scheduling)];
}

/// How the loop keeps up, told with each tick. Times in ns.
struct TickTiming {
    double period = 0.0;            ///< s that the step was told
    std::int64_t over = 0;          ///< CLOCK_MONOTONIC, when the force was sent
    std::int64_t interval = 0;      ///< from the force before to this one; 0: it is the first, or the loop stood
    std::int64_t work = 0, cpu = 0; ///< of the tick before this one, whole: wall clock, processor time of the thread
    std::uint64_t missed = 0;       ///< edges that were skipped since the loop began
    std::uint64_t late = 0;         ///< ticks since the loop began whose force was withheld, as it came too late
    SchedulingClass scheduling = SchedulingClass::normal;
    TickFault fault = TickFault::none; ///< that begins with this tick
    StylusState reading;               ///< as the stylus gave it
};

/// What a loop does at an edge of its clock.
enum class AtEdge : std::uint8_t {
    tick,  ///< goes on
    stand, ///< no tick: zero force, and the next edge asks again; such time is not missed
    full,  ///< no room for what the tick would say: waits where it can, and ends with recordingOverflow where not
};

/// Where the ticks of a loop go. Called by the thread that ticks alone, with neither allocation, lock nor file.
class TickSink {
public:
    virtual ~TickSink() = default;
    /// Between two ticks: here, and only here, the workpiece and the step may be changed by others.
    virtual AtEdge edge() noexcept = 0;
    /// After the force was sent, so that the hand never waits for it.
    virtual void tick(const Sample& sample, const TickTiming& timing) noexcept = 0;
};

/// Every tick into a ring; a full one is for the loop to meet.
class RingSink final : public TickSink {
public:
    explicit RingSink(Ring<Sample>& ring) noexcept : ring_(ring) {}
    AtEdge edge() noexcept override { return ring_.size() < ring_.capacity() ? AtEdge::tick : AtEdge::full; }
    void tick(const Sample& sample, const TickTiming&) noexcept override { ring_.push(sample); }

private:
    Ring<Sample>& ring_;
};

} // namespace burin
