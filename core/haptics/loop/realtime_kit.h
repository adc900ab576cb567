// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// RealtimeKit, the desktop's service that grants real-time scheduling to threads of unprivileged users
/// (org.freedesktop.RealtimeKit1 on the system bus; interface according to its README and introspection). All functions
/// take as long as the bus, at most a second, and allocate: never call them in a tick.
namespace realtimekit {

/// The limits of what the service grants.
struct Limits {
    int maximumPriority = 0; ///< of SCHED_RR
    int minimumNice = 0;     ///< below 0
    /// µs of uninterrupted processor time to which the process must have limited itself (RLIMIT_RTTIME) before it
    /// requests real-time scheduling
    std::int64_t maximumUnbroken = 0;
};

/// Queries the limits. Returns false if there is no such service, or no bus.
bool ask(Limits& limits) noexcept;
/// Requests SCHED_RR for a thread of this process. The thread must not pass the class on to processes that it starts
/// (SCHED_RESET_ON_FORK), or the service refuses.
/// @param thread kernel thread id. Returns false if refused.
bool makeRealtime(std::uint64_t thread, int priority) noexcept;
/// Requests a nice value for a thread. @param nice below 0
bool makeHighPriority(std::uint64_t thread, int nice) noexcept;

} // namespace realtimekit
} // namespace burin
