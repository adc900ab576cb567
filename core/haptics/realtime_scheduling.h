// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/servo_loop.h"

#include <sched.h>

namespace burin {

/// Asks for real-time scheduling of the calling thread as long as it lives; puts back what was before. Never fails:
/// without the right to it the thread stays as it is.
class RealtimeScheduling {
public:
    RealtimeScheduling() noexcept;
    ~RealtimeScheduling();
    RealtimeScheduling(const RealtimeScheduling&) = delete;
    RealtimeScheduling& operator=(const RealtimeScheduling&) = delete;

    SchedulingClass obtained() const noexcept { return obtained_; }

private:
    SchedulingClass obtained_ = SchedulingClass::normal;
    int policyBefore_ = 0;
    sched_param parametersBefore_{};
    int slackBefore_ = -1;
};

} // namespace burin
