// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_registry.h"
#include "tests/hid/guest.h"
#include "tests/hid/uhid_device.h"
#include "tests/plugins/comes_true.h"
#include "tests/plugins/running_board.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace burin::test {

inline constexpr const char* openStylusId = "open_stylus:1209:0001:0001";

inline UhidIdentity openStylusIdentity() {
    return {"Open Stylus mine", "0001", 0x1209, 0x0001,
            Report(open_stylus_descriptor, open_stylus_descriptor + OPEN_STYLUS_DESCRIPTOR_SIZE)};
}

/// A board with the reference firmware, plugged into the kernel.
class PluggedBoard : public RunningBoard {
public:
    /// @param hears receives each output report before the firmware does, on the device's thread
    explicit PluggedBoard(
        const open_stylus_limits& limits = Board::limits(),
        std::function<void(const Report&)> hears = [](const Report&) {})
        : RunningBoard([this](const Board::Report& report) { return device_.send(report); }, limits)
        , hears_(std::move(hears))
        , device_(openStylusIdentity(), {[this](const Report& report) {
                                             hears_(report);
                                             deliver(report);
                                         },
                                         [this](std::uint8_t) { return feature(); }}) {
        start();
    }
    ~PluggedBoard() { stop(); }
    PluggedBoard(const PluggedBoard&) = delete;
    PluggedBoard& operator=(const PluggedBoard&) = delete;

private:
    std::function<void(const Report&)> hears_;
    UhidDevice device_; // last member: its thread uses the others
};

inline bool openStylusIsThere(DeviceRegistry& registry) {
    return comesTrue([&] {
        const auto found = registry.scan();
        return std::ranges::find(found, openStylusId, &FoundDevice::id) != found.end();
    });
}

inline std::unique_ptr<SelfPacedStylus> madeOpenStylus(DeviceRegistry& registry) {
    BURIN_EXPECT(openStylusIsThere(registry));
    auto stylus = registry.make(openStylusId);
    if (!stylus) throw Unmet("make: " + stylus.error().subject + " " + stylus.error().detail);
    return std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*stylus));
}

} // namespace burin::test
