// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/driver.h"

#include "plugins/devices/cap/cap_driver.h"
#include "plugins/devices/spacemouse/models.h"
#include "plugins/devices/spacemouse/space_mouse.h"

namespace burin::spacemouse {
namespace {

bool wanted(const hid::DeviceInfo& device) {
    return isSpaceMouse(device);
}

std::string nameOf(const hid::DeviceInfo& device) {
    if (const Model* model = modelOf(device.vendor, device.product)) return model->name;
    return device.name.empty() ? std::string("SpaceMouse") : device.name;
}

int buttonsOf(const hid::DeviceInfo& device) {
    const Model* model = modelOf(device.vendor, device.product);
    return model != nullptr ? model->buttons : 32;
}

class Driver final : public DeviceDriver {
public:
    explicit Driver(std::unique_ptr<hid::Bus> bus) : bus_(std::move(bus)) {}

    std::vector<FoundDevice> find() override {
        std::vector<FoundDevice> found;
        const std::vector<hid::DeviceInfo> devices = hid::devicesOn(*bus_, wanted);
        for (const hid::DeviceInfo& device : devices)
            found.push_back({hid::idOf(device, devices), nameOf(device), cap::modes()});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (const Result<void> known = cap::checkMode(mode); !known) return known.error();
        const std::optional<hid::DeviceInfo> device = hid::deviceWithId(*bus_, wanted, id);
        if (!device) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        Result<std::unique_ptr<hid::Port>> port = bus_->open(*device);
        if (!port) return std::move(port).error();
        cap::CapStylusSettings settings;
        settings.name = nameOf(*device);
        settings.buttons = buttonsOf(*device);
        settings.rate = {62.5, "recordings of SpaceNavigator and SpaceMouse Wireless: full sets of axes a second"};
        settings.staleAfter = SpaceMouse::staleAfter;
        settings.mode = cap::modeOf(mode);
        return AnyStylus(std::unique_ptr<Stylus>(std::make_unique<cap::CapStylus>(
            std::make_unique<SpaceMouse>(*bus_, std::move(*port), id), std::move(settings))));
    }

private:
    std::unique_ptr<hid::Bus> bus_;
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver(std::unique_ptr<hid::Bus> bus) {
    return std::make_unique<Driver>(std::move(bus));
}

} // namespace burin::spacemouse
