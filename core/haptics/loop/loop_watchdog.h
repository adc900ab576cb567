// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/haptics/loop/heartbeat.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace burin {

/// Hears that a loop is dead.
class LoopAlarm {
public:
    virtual ~LoopAlarm() = default;
    /// On the watchdog's thread, after the motors were cut. Once until the loop lives again.
    virtual void loopDied() noexcept = 0;
};

/// Looks at a loop's heartbeat from a thread of its own, and cuts the motors of the stylus when it stops: the loop may
/// hang in a tick, in the device, or not be given the processor. Looks at the moment when patience would be over, not
/// at intervals, so that the motors are off as soon as this thread runs. Their way back is the loop's: its first force
/// after such a gap is zero, and forces fade in.
class LoopWatchdog {
public:
    /// @param patience s without a beat. @param alarm may be null. What is given outlives the watchdog.
    LoopWatchdog(StylusDevice& device, const Heartbeat& heart, double patience, LoopAlarm* alarm);
    /// Waits for a cut under way, which waits for the device.
    ~LoopWatchdog();
    LoopWatchdog(const LoopWatchdog&) = delete;
    LoopWatchdog& operator=(const LoopWatchdog&) = delete;

    struct Cuts {
        std::uint64_t count = 0;
        double longest = 0.0; ///< s from the last beat until the device had been told
    };
    /// Any thread.
    Cuts cuts() const noexcept;

private:
    void watch(const std::stop_token& stop) noexcept;
    void cut(std::int64_t lastBeat) noexcept;

    StylusDevice& device_;
    const Heartbeat& heart_;
    const std::int64_t patience_; ///< ns
    LoopAlarm* alarm_;
    std::atomic<std::uint64_t> count_{0};
    std::atomic<std::int64_t> longest_{0}; ///< ns
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_; // last: it uses the above
};

} // namespace burin
