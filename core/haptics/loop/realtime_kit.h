// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// RealtimeKit, the desktop's service that grants real-time scheduling to threads of unprivileged users
/// (org.freedesktop.RealtimeKit1 on the system bus; interface as its README and introspection state it). All of it
/// takes as long as the bus, at most a second, and allocates: never in a tick.
namespace realtimekit {

/// What it grants at most.
struct Limits {
    int maximumPriority = 0; ///< of SCHED_RR
    int minimumNice = 0;     ///< below 0
    /// µs of unbroken processor time that the process must have limited itself to (RLIMIT_RTTIME) before it asks
    std::int64_t maximumUnbroken = 0;
};

/// False: there is no such service, or no bus.
bool ask(Limits& limits) noexcept;
/// SCHED_RR for a thread of this process. The thread must not hand the class on to what it starts
/// (SCHED_RESET_ON_FORK), or the service refuses.
/// @param thread as the kernel counts. False: refused.
bool makeRealtime(std::uint64_t thread, int priority) noexcept;
/// @param nice below 0
bool makeHighPriority(std::uint64_t thread, int nice) noexcept;

} // namespace realtimekit
} // namespace burin
