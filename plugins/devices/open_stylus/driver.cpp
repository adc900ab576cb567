// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/driver.h"

#include "plugins/devices/open_stylus/open_stylus.h"

namespace burin::openstylus {
namespace {

std::string nameOf(const hid::DeviceInfo& device) {
    return device.name.empty() ? std::string("Open Stylus") : device.name;
}

class Driver final : public DeviceDriver {
public:
    explicit Driver(std::unique_ptr<hid::Bus> bus) : bus_(std::move(bus)) {}

    std::vector<FoundDevice> find() override {
        std::vector<FoundDevice> found;
        const std::vector<hid::DeviceInfo> devices = hid::devicesOn(*bus_, speaksProtocol);
        for (const hid::DeviceInfo& device : devices) found.push_back({hid::idOf(device, devices), nameOf(device), {}});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!mode.empty()) return Error{ErrorCode::nameUnknown, "stylus", mode, {}};
        const std::optional<hid::DeviceInfo> device = hid::deviceWithId(*bus_, speaksProtocol, id);
        if (!device) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        Result<std::unique_ptr<hid::Port>> port = bus_->open(*device);
        if (!port) return std::move(port).error();
        const Result<Identity> identity = identify(**port, nameOf(*device));
        if (!identity) return identity.error();
        return AnyStylus(std::unique_ptr<SelfPacedStylus>(
            std::make_unique<OpenStylus>(*bus_, std::move(*port), *identity, id, nameOf(*device))));
    }

private:
    std::unique_ptr<hid::Bus> bus_;
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver(std::unique_ptr<hid::Bus> bus) {
    return std::make_unique<Driver>(std::move(bus));
}

} // namespace burin::openstylus
