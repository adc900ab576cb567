// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <atomic>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace burin {

/// A thread of a driver, which runs until it is stopped. `runs` may be asked on any thread; everything else belongs to
/// the owner's thread. The owner stops it before what the thread uses is destroyed.
class DriverThread {
public:
    /// Calls `work()` on a new thread; it returns soon after `runs` is false. @param name of the device, for the error
    /// Errors: argumentInvalid (already running), outOfMemory.
    template <class Work>
    Result<void> start(const std::string& name, Work work) {
        if (started()) return Error{ErrorCode::argumentInvalid, "stylus", "started", "a stylus that stands"};
        stop_.store(false, std::memory_order_relaxed);
        try {
            thread_ = std::thread(std::move(work));
        } catch (const std::system_error&) {
            return Error{ErrorCode::outOfMemory, name, {}, "no thread"};
        }
        return {};
    }
    bool started() const noexcept { return thread_.joinable(); }
    bool runs() const noexcept { return !stop_.load(std::memory_order_relaxed); }
    void end() noexcept { stop_.store(true, std::memory_order_relaxed); } ///< asks the thread to return
    void stop() noexcept {                                                ///< `end`, and waits until it has returned
        if (!started()) return;
        end();
        thread_.join();
    }

private:
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace burin
