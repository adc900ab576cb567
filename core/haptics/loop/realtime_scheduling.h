// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/tick_sink.h"

#include <cstddef>
#include <sched.h>

namespace burin {

/// Requests real-time scheduling of the calling thread for the lifetime of the object, and restores the previous
/// scheduling afterwards: SCHED_FIFO if the limits allow it, otherwise SCHED_RR and otherwise a negative nice value
/// from RealtimeKit. Never fails: without permission for any of these the thread keeps its scheduling.
///
/// RealtimeKit requires the process to limit the uninterrupted processor time of real-time threads (RLIMIT_RTTIME,
/// usually 200 ms; permanently, for the whole process). At half of that the kernel warns with SIGXCPU; its handler puts
/// all such threads of the program back to the normal class, so that a tick that hangs loses its class and does not end
/// the program.
class RealtimeScheduling {
public:
    enum class Role : std::uint8_t {
        loop,
        watchdog, ///< priority one above the loop's: the loop must not keep the watchdog from running
    };
    explicit RealtimeScheduling(Role role) noexcept;
    ~RealtimeScheduling();
    RealtimeScheduling(const RealtimeScheduling&) = delete;
    RealtimeScheduling& operator=(const RealtimeScheduling&) = delete;

    /// Any thread. Normal again once the kernel has sent a warning.
    SchedulingClass obtained() const noexcept;

private:
    bool askLimits(int priority) noexcept;
    void askKit(int priority) noexcept;

    SchedulingClass obtained_ = SchedulingClass::normal;
    int thread_;
    int policyBefore_ = SCHED_OTHER, niceBefore_ = 0;
    sched_param parametersBefore_{};
    int slackBefore_ = -1;
    int place_ = -1; ///< index among the threads known to the signal handler
};

} // namespace burin
