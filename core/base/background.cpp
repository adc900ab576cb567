// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/background.h"

#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>
#include <unistd.h>

namespace burin {

namespace {

constexpr int backgroundNice = 10; // Linux: a weight of 110 instead of 1024

class HelperObserver final : public oneapi::tbb::task_scheduler_observer {
public:
    HelperObserver() { observe(true); }
    void on_scheduler_entry(bool isWorker) override {
        if (isWorker) workInBackground();
    }
};

} // namespace

void workInBackground() noexcept {
    static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), backgroundNice));
}

void helpInBackground() {
    static auto& observer = *new HelperObserver; // never destroyed: workers may outlive static objects
    static_cast<void>(observer);
}

} // namespace burin
