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
    bool arrived = false; ///< false: it left
    FoundDevice device;
};

/// Watches what is plugged in and out, on a thread of its own.
class DeviceWatch {
public:
    static constexpr std::chrono::milliseconds usualInterval{500};

    /// @param heard on the watch's thread: the devices that are there at first, then each change. Not the simulated
    /// stylus, which is always there. @param registry outlives the watch.
    DeviceWatch(DeviceRegistry& registry, std::function<void(const DeviceChange&)> heard,
                std::chrono::milliseconds interval = usualInterval);
    /// `heard` is not called any more afterwards. Waits for a scan under way.
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

/// What changed from one scan to the next, those that left first.
std::vector<DeviceChange> changesBetween(const std::vector<FoundDevice>& before, const std::vector<FoundDevice>& after);

} // namespace burin
