// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace burin {

/// Signals to other threads that a loop is alive. One thread calls `beat`, any thread may read it.
class Heartbeat {
public:
    /// @param nanoseconds of CLOCK_MONOTONIC, above 0
    void beat(std::int64_t nanoseconds) noexcept { last_.store(nanoseconds, std::memory_order_release); }
    /// Suspends monitoring until the next beat, because there is no device that could push.
    void rest() noexcept { last_.store(0, std::memory_order_release); }
    /// ns, time of the newest beat; 0: monitoring is suspended.
    std::int64_t last() const noexcept { return last_.load(std::memory_order_acquire); }

private:
    std::atomic<std::int64_t> last_{0};
};

} // namespace burin
