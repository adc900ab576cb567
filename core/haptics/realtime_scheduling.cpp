// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/realtime_scheduling.h"

#include <pthread.h>
#include <sys/prctl.h>

namespace burin {
namespace {

/// What rtkit grants at most by default; high enough for a desktop, below the kernel's own threads.
constexpr int priority = 20;

} // namespace

RealtimeScheduling::RealtimeScheduling() noexcept {
    slackBefore_ = prctl(PR_GET_TIMERSLACK);
    prctl(PR_SET_TIMERSLACK, 1UL); // ns; the default of 50 µs is added to every sleep of a normal thread
    if (pthread_getschedparam(pthread_self(), &policyBefore_, &parametersBefore_) != 0) return;
    sched_param wanted{};
    wanted.sched_priority = priority;
    // Reset on fork: no program started from here inherits the class.
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO | SCHED_RESET_ON_FORK, &wanted) == 0)
        obtained_ = SchedulingClass::fifo;
}

RealtimeScheduling::~RealtimeScheduling() {
    if (obtained_ != SchedulingClass::normal) pthread_setschedparam(pthread_self(), policyBefore_, &parametersBefore_);
    if (slackBefore_ > 0) prctl(PR_SET_TIMERSLACK, static_cast<unsigned long>(slackBefore_));
}

} // namespace burin
