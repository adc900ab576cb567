// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/hd_scheduler.h"

#include "plugins/devices/openhaptics/hd_faults.h"

namespace burin::openhaptics {
namespace {

constexpr int mostErrors = 64; // on the stack of errors; limits the loop if the stack never becomes empty

/// Removes all errors from the library's stack. Returns the oldest one, which caused the others; 0 if there is none.
unsigned int takeErrors(const HdApi& api) noexcept {
    unsigned int first = 0;
    for (int i = 0; i < mostErrors; ++i) {
        const unsigned int code = api.getError().code;
        if (code == 0) break;
        first = code; // the newest is returned first
    }
    return first;
}

} // namespace

void HdScheduler::pause() noexcept {
    if (callbacks_ > 0) api_.stopScheduler();
}

void HdScheduler::goOn() noexcept {
    if (callbacks_ > 0) api_.startScheduler();
}

Result<HdHandle> HdScheduler::connect(const std::string& name, const std::function<Result<void>()>& prepare) {
    const std::lock_guard lock(mutex_);
    pause();
    (void)takeErrors(api_); // errors of other calls
    const HdHandle handle = api_.initDevice(name.c_str());
    Result<HdHandle> answer = handle;
    if (const unsigned int code = takeErrors(api_); code != 0 || handle == hdInvalidHandle) {
        answer = connectionError(code, name);
    } else {
        api_.makeCurrentDevice(handle);
        if (Result<void> prepared = prepare(); !prepared) {
            api_.disableDevice(handle);
            answer = prepared.error();
        }
    }
    goOn();
    return answer;
}

void HdScheduler::disconnect(HdHandle handle) noexcept {
    const std::lock_guard lock(mutex_);
    pause();
    api_.disableDevice(handle);
    goOn();
}

HdScheduled HdScheduler::add(HdCallback callback, void* self) noexcept {
    const std::lock_guard lock(mutex_);
    const HdScheduled scheduled = api_.scheduleAsynchronous(callback, self, hdHighestPriority);
    if (callbacks_++ == 0) {
        api_.setSchedulerRate(rate);
        api_.startScheduler();
    }
    return scheduled;
}

void HdScheduler::remove(HdScheduled scheduled, bool done) noexcept {
    const std::lock_guard lock(mutex_);
    if (--callbacks_ == 0) api_.stopScheduler();
    if (!done) api_.unschedule(scheduled);
}

} // namespace burin::openhaptics
