// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/realtime_scheduling.h"

#include "core/haptics/loop/realtime_kit.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace burin {
namespace {

/// High enough for a desktop, below the kernel's own threads; by default RealtimeKit grants at most 20.
constexpr int loopPriority = 19, watchdogPriority = 20;

/// Threads that the kernel may send a warning for; 0: free; negative: it has sent one. Atomics that a signal handler
/// may read and write.
std::array<std::atomic<int>, 8> warned{};

void demoteAll(int) {
    const sched_param normal{};
    for (std::atomic<int>& place : warned) {
        int thread = place.load();
        if (thread > 0 && place.compare_exchange_strong(thread, -thread))
            sched_setscheduler(thread, SCHED_OTHER | SCHED_RESET_ON_FORK, &normal);
    }
}

/// Installs the handler once per process; a handler of other code is kept.
bool heedsWarning() noexcept {
    static const bool heeds = [] {
        struct sigaction before {};
        if (sigaction(SIGXCPU, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) return false;
        struct sigaction action {};
        action.sa_handler = demoteAll;
        action.sa_flags = SA_RESTART;
        sigfillset(&action.sa_mask);
        return sigaction(SIGXCPU, &action, nullptr) == 0;
    }();
    return heeds;
}

bool limitUnbroken(std::int64_t microseconds) noexcept {
    rlimit limit{};
    if (microseconds <= 0 || getrlimit(RLIMIT_RTTIME, &limit) != 0) return false;
    const auto most = static_cast<rlim_t>(microseconds);
    limit.rlim_max = std::min(limit.rlim_max, most);
    limit.rlim_cur = std::min(limit.rlim_cur, most / 2);
    return setrlimit(RLIMIT_RTTIME, &limit) == 0;
}

int takePlace(int thread) noexcept {
    for (std::size_t i = 0; i < warned.size(); ++i)
        if (int none = 0; warned[i].compare_exchange_strong(none, thread)) return static_cast<int>(i);
    return -1;
}

} // namespace

RealtimeScheduling::RealtimeScheduling(Role role) noexcept : thread_(gettid()) {
    slackBefore_ = prctl(PR_GET_TIMERSLACK);
    prctl(PR_SET_TIMERSLACK, 1UL); // ns; the default of 50 µs is added to every sleep of a normal thread
    if (pthread_getschedparam(pthread_self(), &policyBefore_, &parametersBefore_) != 0) return;
    niceBefore_ = getpriority(PRIO_PROCESS, static_cast<id_t>(thread_));
    const int priority = role == Role::loop ? loopPriority : watchdogPriority;
    if (!askLimits(priority)) askKit(priority);
}

bool RealtimeScheduling::askLimits(int priority) noexcept {
    sched_param wanted{};
    wanted.sched_priority = priority;
    // Reset on fork: programs started from here do not inherit the class.
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO | SCHED_RESET_ON_FORK, &wanted) != 0) return false;
    obtained_ = SchedulingClass::fifo;
    // Other code may have limited the process as RealtimeKit requires: without a handler that limit ends the program.
    rlimit unbroken{};
    if (getrlimit(RLIMIT_RTTIME, &unbroken) == 0 && unbroken.rlim_cur != RLIM_INFINITY && heedsWarning())
        place_ = takePlace(thread_);
    return true;
}

void RealtimeScheduling::askKit(int priority) noexcept {
    realtimekit::Limits limits;
    if (!realtimekit::ask(limits)) return;
    const auto thread = static_cast<std::uint64_t>(thread_);
    // The slot is taken first: no thread gets the class if the handler would not find it.
    if (limits.maximumPriority > 0 && heedsWarning()) place_ = takePlace(thread_);
    const sched_param normal{};
    if (place_ >= 0 && limitUnbroken(limits.maximumUnbroken) &&
        sched_setscheduler(0, SCHED_OTHER | SCHED_RESET_ON_FORK, &normal) == 0 &&
        realtimekit::makeRealtime(thread, std::min(priority, limits.maximumPriority)))
        obtained_ = SchedulingClass::roundRobin;
    else if (limits.minimumNice < 0 && realtimekit::makeHighPriority(thread, limits.minimumNice))
        obtained_ = SchedulingClass::nice;
}

SchedulingClass RealtimeScheduling::obtained() const noexcept {
    const bool demoted = place_ >= 0 && warned[static_cast<std::size_t>(place_)].load(std::memory_order_relaxed) < 0;
    return demoted && obtained_ != SchedulingClass::nice ? SchedulingClass::normal : obtained_;
}

RealtimeScheduling::~RealtimeScheduling() {
    if (obtained_ == SchedulingClass::nice) setpriority(PRIO_PROCESS, static_cast<id_t>(thread_), niceBefore_);
    // Without privileges the flag can't be cleared again.
    if ((obtained_ == SchedulingClass::fifo || obtained_ == SchedulingClass::roundRobin) &&
        pthread_setschedparam(pthread_self(), policyBefore_, &parametersBefore_) != 0)
        pthread_setschedparam(pthread_self(), policyBefore_ | SCHED_RESET_ON_FORK, &parametersBefore_);
    if (place_ >= 0) warned[static_cast<std::size_t>(place_)].store(0);
    if (slackBefore_ > 0) prctl(PR_SET_TIMERSLACK, static_cast<unsigned long>(slackBefore_));
}

} // namespace burin
