// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/tick_sink.h"

#include <cstddef>
#include <sched.h>

namespace burin {

/// Asks for real-time scheduling of the calling thread as long as it lives, and puts back what was before: SCHED_FIFO
/// where the limits allow it, else SCHED_RR and else a negative nice value from RealtimeKit. Never fails: without the
/// right to any of it the thread stays as it is.
///
/// RealtimeKit wants the process to limit a real-time thread's unbroken processor time (RLIMIT_RTTIME, 200 ms as a
/// rule; lasting, for the whole process). At half of that the kernel warns with SIGXCPU; its handler puts all such
/// threads of ours back to the normal class, so that a tick that hangs costs its class and not the program.
class RealtimeScheduling {
public:
    enum class Role : std::uint8_t {
        loop,
        watchdog, ///< one above: what the loop does must not keep it from looking
    };
    explicit RealtimeScheduling(Role role) noexcept;
    ~RealtimeScheduling();
    RealtimeScheduling(const RealtimeScheduling&) = delete;
    RealtimeScheduling& operator=(const RealtimeScheduling&) = delete;

    /// Any thread. Normal again once the kernel had to warn.
    SchedulingClass obtained() const noexcept;

private:
    bool askLimits(int priority) noexcept;
    void askKit(int priority) noexcept;

    SchedulingClass obtained_ = SchedulingClass::normal;
    int thread_;
    int policyBefore_ = SCHED_OTHER, niceBefore_ = 0;
    sched_param parametersBefore_{};
    int slackBefore_ = -1;
    int place_ = -1; ///< among the threads that the handler knows
};

} // namespace burin
