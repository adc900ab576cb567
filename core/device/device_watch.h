// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_registry.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace burin {

struct DeviceChange {
    bool arrived = false; ///< false: it was unplugged
    FoundDevice device;
};

/// Watches devices being plugged in and unplugged, on a thread of its own.
class DeviceWatch {
public:
    static constexpr std::chrono::milliseconds usualInterval{500};

    /// @param heard called on the watch's thread: first for each device that is already connected, then for each
    /// change. Never called for the simulated stylus, which is always available. @param registry outlives the watch.
    DeviceWatch(DeviceRegistry& registry, std::function<void(const DeviceChange&)> heard,
                std::chrono::milliseconds interval = usualInterval);
    /// Waits for a scan in progress; `heard` is not called any more afterwards.
    ~DeviceWatch();
    DeviceWatch(const DeviceWatch&) = delete;
    DeviceWatch& operator=(const DeviceWatch&) = delete;

private:
    void run(const std::stop_token& stop);

    DeviceRegistry& registry_;
    std::function<void(const DeviceChange&)> heard_;
    std::chrono::milliseconds interval_;
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_;
};

/// The changes from one scan to the next, the devices that were unplugged first.
std::vector<DeviceChange> changesBetween(const std::vector<FoundDevice>& before, const std::vector<FoundDevice>& after);

} // namespace burin
