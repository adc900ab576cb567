// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <cstdint>
#include <time.h>

namespace burin {

inline constexpr std::int64_t nanosecondsPerSecond = 1'000'000'000;

inline constexpr std::int64_t nanoseconds(double seconds) noexcept {
    return static_cast<std::int64_t>(seconds * static_cast<double>(nanosecondsPerSecond) + 0.5);
}
inline constexpr double seconds(std::int64_t nanoseconds) noexcept {
    return static_cast<double>(nanoseconds) / static_cast<double>(nanosecondsPerSecond);
}

/// The time of a clock in ns. CLOCK_MONOTONIC is read without entering the kernel; the processor time of a thread is
/// not.
inline std::int64_t now(clockid_t clock = CLOCK_MONOTONIC) noexcept {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<std::int64_t>(time.tv_sec) * nanosecondsPerSecond + time.tv_nsec;
}

/// Sleeps until an absolute time of CLOCK_MONOTONIC, so that repeated calls do not drift.
inline void sleepUntil(std::int64_t nanoseconds) noexcept {
    timespec edge{};
    edge.tv_sec = static_cast<time_t>(nanoseconds / nanosecondsPerSecond);
    edge.tv_nsec = static_cast<long>(nanoseconds % nanosecondsPerSecond);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &edge, nullptr) == EINTR) {
    }
}

} // namespace burin
