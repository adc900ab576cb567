// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/driver.h"

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
            found.push_back({hid::idOf(device, devices),
                             nameOf(device),
                             {{"rate", BURIN_TEXT("Device", "The cap sets the speed")},
                              {"position", BURIN_TEXT("Device", "The cap sets the position")}}});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!mode.empty() && mode != "rate" && mode != "position")
            return Error{ErrorCode::nameUnknown, "stylus", mode, "rate, position"};
        const std::optional<hid::DeviceInfo> device = hid::deviceWithId(*bus_, wanted, id);
        if (!device) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        Result<std::unique_ptr<hid::Port>> port = bus_->open(*device);
        if (!port) return std::move(port).error();
        return AnyStylus(std::unique_ptr<Stylus>(
            std::make_unique<SpaceMouse>(*bus_, std::move(*port), id, nameOf(*device), buttonsOf(*device),
                                         mode == "position" ? ControlMode::position : ControlMode::rate)));
    }

private:
    std::unique_ptr<hid::Bus> bus_;
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver(std::unique_ptr<hid::Bus> bus) {
    return std::make_unique<Driver>(std::move(bus));
}

} // namespace burin::spacemouse
