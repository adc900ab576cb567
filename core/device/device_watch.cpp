// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_watch.h"

#include <algorithm>

namespace burin {

std::vector<DeviceChange> changesBetween(const std::vector<FoundDevice>& before,
                                         const std::vector<FoundDevice>& after) {
    const auto has = [](const std::vector<FoundDevice>& devices, const FoundDevice& device) {
        return std::ranges::find(devices, device.id, &FoundDevice::id) != devices.end();
    };
    std::vector<DeviceChange> changes;
    for (const FoundDevice& device : before)
        if (!has(after, device)) changes.push_back({false, device});
    for (const FoundDevice& device : after)
        if (!has(before, device)) changes.push_back({true, device});
    return changes;
}

DeviceWatch::DeviceWatch(DeviceRegistry& registry, std::function<void(const DeviceChange&)> heard,
                         std::chrono::milliseconds interval)
    : registry_(registry)
    , heard_(std::move(heard))
    , interval_(interval)
    , thread_([this](const std::stop_token& stop) { run(stop); }) {}

DeviceWatch::~DeviceWatch() {
    thread_.request_stop();
    thread_.join();
}

void DeviceWatch::run(const std::stop_token& stop) {
    std::vector<FoundDevice> known;
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        std::vector<FoundDevice> now = registry_.scan();
        std::erase_if(now, [](const FoundDevice& device) { return device.id == simulatedDevice; });
        for (const DeviceChange& change : changesBetween(known, now)) heard_(change);
        known = std::move(now);
        // until the interval has passed, or a stop is requested
        woken_.wait_for(lock, stop, interval_, [] { return false; });
    }
}

} // namespace burin
