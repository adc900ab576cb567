// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/driver.h"

#include "plugins/devices/cap/cap_driver.h"
#include "plugins/devices/input_events/input_devices.h"
#include "plugins/devices/input_events/pad_source.h"
#include "plugins/devices/input_events/tablet_stylus.h"

#include <algorithm>

namespace burin::input_events {
namespace {

AnyStylus padStylus(ReopenedPort port, const InputDevice& device, const std::string& mode) {
    auto source = std::make_unique<PadSource>(std::move(port));
    cap::CapStylusSettings settings;
    settings.name = device.name;
    settings.buttons = source->reader().buttonCount();
    settings.axes = source->reader().axes();
    settings.map = source->reader().map();
    settings.fullScale = PadReader::fullScale;
    settings.silent = source->reader().controls().silent;
    settings.mode = cap::modeOf(mode);
    return std::unique_ptr<Stylus>(std::make_unique<cap::CapStylus>(std::move(source), std::move(settings)));
}

class Driver final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override {
        std::vector<FoundDevice> found;
        for (const InputDevice& device : inputDevices())
            found.push_back(
                {device.id, device.name, device.kind == InputKind::gamepad ? cap::modes() : std::vector<DeviceMode>()});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        const std::vector<InputDevice> devices = inputDevices();
        const auto device = std::ranges::find(devices, id, &InputDevice::id);
        if (device == devices.end()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        const bool pad = device->kind == InputKind::gamepad;
        if (pad) {
            if (const Result<void> known = cap::checkMode(mode); !known) return known.error();
        } else if (!mode.empty()) {
            return Error{ErrorCode::nameUnknown, "mode", mode, {}};
        }
        Result<ReopenedPort> port = ReopenedPort::open(*device);
        if (!port) return std::move(port).error();
        if (pad) return padStylus(std::move(*port), *device, mode);
        return AnyStylus(std::unique_ptr<Stylus>(std::make_unique<TabletStylus>(std::move(*port), device->name)));
    }
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::input_events
