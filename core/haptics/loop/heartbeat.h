// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace burin {

/// Tells other threads that a loop lives. One thread beats, any may look.
class Heartbeat {
public:
    /// @param nanoseconds of CLOCK_MONOTONIC, above 0
    void beat(std::int64_t nanoseconds) noexcept { last_.store(nanoseconds, std::memory_order_release); }
    /// Nobody need worry until the next beat: there is no device to push.
    void rest() noexcept { last_.store(0, std::memory_order_release); }
    /// ns of the newest beat; 0: it rests.
    std::int64_t last() const noexcept { return last_.load(std::memory_order_acquire); }

private:
    std::atomic<std::int64_t> last_{0};
};

} // namespace burin
