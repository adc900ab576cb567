// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_watchdog.h"

#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/realtime_scheduling.h"

#include <algorithm>
#include <chrono>

namespace burin {

LoopWatchdog::LoopWatchdog(StylusDevice& device, const Heartbeat& heart, double patience, LoopAlarm* alarm)
    : device_(device)
    , heart_(heart)
    , patience_(nanoseconds(patience))
    , alarm_(alarm)
    , thread_([this](const std::stop_token& stop) { watch(stop); }) {}

LoopWatchdog::~LoopWatchdog() {
    thread_.request_stop();
    thread_.join();
}

LoopWatchdog::Cuts LoopWatchdog::cuts() const noexcept {
    return {count_.load(std::memory_order_acquire), seconds(longest_.load(std::memory_order_relaxed))};
}

void LoopWatchdog::watch(const std::stop_token& stop) noexcept {
    const RealtimeScheduling scheduling(RealtimeScheduling::Role::watchdog);
    std::int64_t cutFor = 0; // the beat after which the motors were last cut
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        const std::int64_t last = heart_.last(), time = now();
        const bool dead = last > 0 && last != cutFor && time - last >= patience_;
        if (dead) {
            cut(last);
            cutFor = last;
        }
        // A suspended loop may resume right now: its allowed time is over one such time later at the earliest.
        const bool beats = last > 0 && last != cutFor;
        const std::int64_t next = beats ? last + patience_ : now() + patience_ / 2;
        woken_.wait_for(lock, stop, std::chrono::nanoseconds(std::max<std::int64_t>(next - now(), 0)),
                        [] { return false; });
    }
}

void LoopWatchdog::cut(std::int64_t lastBeat) noexcept {
    device_.cutMotors();
    longest_.store(std::max(longest_.load(std::memory_order_relaxed), now() - lastBeat), std::memory_order_relaxed);
    count_.fetch_add(1, std::memory_order_release);
    if (alarm_ != nullptr) alarm_->loopDied();
}

} // namespace burin
