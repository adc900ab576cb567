// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/driver.h"

#include "plugins/devices/cap/cap_driver.h"
#include "plugins/devices/input_events/assisted_stylus.h"
#include "plugins/devices/input_events/input_devices.h"
#include "plugins/devices/input_events/pad_source.h"
#include "plugins/devices/input_events/tablet_stylus.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace burin::input_events {
namespace {

std::unique_ptr<Stylus> padStylus(ReopenedPort port, const InputDevice& device, const std::string& mode) {
    auto source = std::make_unique<PadSource>(std::move(port));
    cap::CapStylusSettings settings;
    settings.name = device.name;
    settings.buttons = source->reader().buttonCount();
    settings.axes = source->reader().axes();
    settings.map = source->reader().map();
    settings.fullScale = PadReader::fullScale;
    settings.silent = source->reader().controls().silent;
    settings.mode = cap::modeOf(mode);
    return std::make_unique<cap::CapStylus>(std::move(source), std::move(settings));
}

/// A stick pushes only if it is known which axes are its own.
AssistAbilities abilitiesOf(const InputDevice& device, const Stylus& pad) {
    const std::vector<DeviceAxis> axes = pad.axes();
    const bool stick = axes.size() >= 2 && axes[0].name == "X" && axes[1].name == "Y";
    return {device.force.rumble, stick ? device.force.axes : 0, ::access(device.node.c_str(), W_OK) == 0};
}

/// Finds the device by its id each time: its node changes when it is plugged in again.
OpenEffectPort portOf(const InputDevice& device) {
    return [id = device.id](int& fault) -> std::unique_ptr<EffectPort> {
        const std::vector<InputDevice> devices = inputDevices();
        const auto found = std::ranges::find(devices, id, &InputDevice::id);
        fault = ENODEV;
        return found == devices.end() ? nullptr : openEffectPort(found->node, fault);
    };
}

AnyStylus assisted(std::unique_ptr<Stylus> pad, const InputDevice& device) {
    const AssistAbilities abilities = abilitiesOf(device, *pad);
    if (!abilities.rumble && abilities.forceAxes == 0) return pad;
    ForceAbilities force = device.force;
    force.constant = abilities.forceAxes > 0;
    auto writer = std::make_unique<ForceWriter>(portOf(device), force, device.name, device.node.string());
    return std::unique_ptr<Stylus>(std::make_unique<AssistedStylus>(std::move(pad), std::move(writer), abilities));
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
        if (pad) return assisted(padStylus(std::move(*port), *device, mode), *device);
        return AnyStylus(std::unique_ptr<Stylus>(std::make_unique<TabletStylus>(std::move(*port), device->name)));
    }
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::input_events
