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

/// Is notified when a loop is dead.
class LoopAlarm {
public:
    virtual ~LoopAlarm() = default;
    /// Called on the watchdog's thread, after the motors were cut. Called once until the loop is alive again.
    virtual void loopDied() noexcept = 0;
};

/// Monitors a loop's heartbeat on a thread of its own, and cuts the motors of the stylus when it stops: the loop may
/// hang in a tick or in the device, or may not get the processor. It checks exactly when the allowed time would be
/// over, not periodically, so that the motors are off as soon as this thread runs. The loop switches them on again: its
/// first force after such a gap is zero, and forces fade in.
class LoopWatchdog {
public:
    /// @param patience allowed time without a beat, s. @param alarm may be null. All arguments must outlive the
    /// watchdog.
    LoopWatchdog(StylusDevice& device, const Heartbeat& heart, double patience, LoopAlarm* alarm);
    /// Waits for a cut in progress, which waits for the device.
    ~LoopWatchdog();
    LoopWatchdog(const LoopWatchdog&) = delete;
    LoopWatchdog& operator=(const LoopWatchdog&) = delete;

    struct Cuts {
        std::uint64_t count = 0;
        double longest = 0.0; ///< s, from the last beat until the device had received the command
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
