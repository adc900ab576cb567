// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_registry.h"
#include "tests/hid/descriptors.h"
#include "tests/hid/guest.h"
#include "tests/plugins/comes_true.h"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace burin::test {

/// A 3D mouse plugged into the kernel, and the reports that the host wrote to it.
class PluggedMouse {
public:
    PluggedMouse(std::uint16_t vendor, std::uint16_t product, std::string_view descriptor, std::string serial = {})
        : device_({"3D mouse", std::move(serial), vendor, product, bytesOf(descriptor)},
                  {[this](const Report& report) {
                       const std::lock_guard lock(mutex_);
                       outputs_.push_back(report);
                   },
                   {}}) {}
    void send(std::string_view hex) { device_.send(bytesOf(hex)); }
    void send(const Report& report) { device_.send(report); }
    std::vector<Report> outputs() {
        const std::lock_guard lock(mutex_);
        return outputs_;
    }

private:
    std::mutex mutex_;
    std::vector<Report> outputs_;
    UhidDevice device_; // last member: its thread uses the others
};

inline std::optional<FoundDevice> foundAs(DeviceRegistry& registry, const std::string& id) {
    std::optional<FoundDevice> result;
    comesTrue([&] {
        for (const FoundDevice& found : registry.scan())
            if (found.id == id) result = found;
        return result.has_value();
    });
    return result;
}

/// The open stylus of a mouse that is plugged in.
inline std::unique_ptr<Stylus> openedMouse(DeviceRegistry& registry, const std::string& id,
                                           const std::string& mode = {}) {
    BURIN_EXPECT(foundAs(registry, id));
    auto made = registry.make(id, mode);
    if (!made) throw Unmet("make: " + made.error().subject + " " + made.error().detail);
    auto stylus = std::move(std::get<std::unique_ptr<Stylus>>(*made));
    BURIN_EXPECT(stylus->open());
    return stylus;
}

} // namespace burin::test
