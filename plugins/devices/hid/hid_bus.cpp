// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/hid/hid_bus.h"

#include <hidapi.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <unistd.h>

namespace burin::hid {
namespace {

/// Converts hidapi's wide text to UTF-8. On Linux a wide character is a code point.
std::string textOf(const wchar_t* wide) {
    std::string text;
    for (; wide != nullptr && *wide != L'\0'; ++wide) {
        const auto point = static_cast<std::uint32_t>(*wide);
        const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
        if (point < 0x80) {
            add(point);
        } else if (point < 0x800) {
            add(0xc0U | point >> 6U);
            add(0x80U | (point & 0x3fU));
        } else if (point < 0x10000) {
            add(0xe0U | point >> 12U);
            add(0x80U | (point >> 6U & 0x3fU));
            add(0x80U | (point & 0x3fU));
        } else if (point < 0x110000) {
            add(0xf0U | point >> 18U);
            add(0x80U | (point >> 12U & 0x3fU));
            add(0x80U | (point >> 6U & 0x3fU));
            add(0x80U | (point & 0x3fU));
        }
    }
    return text;
}

class SystemPort final : public Port {
public:
    SystemPort(DeviceHost& host, hid_device* device) : host_(host), device_(device) {}
    ~SystemPort() override {
        const std::lock_guard lock(host_.bus);
        hid_close(device_);
    }
    SystemPort(const SystemPort&) = delete;
    SystemPort& operator=(const SystemPort&) = delete;

    int read(std::span<std::uint8_t> bytes, int milliseconds) noexcept override {
        errno = 0;
        const int size = hid_read_timeout(device_, bytes.data(), bytes.size(), milliseconds);
        return size < 0 && errno == EINTR ? 0 : size; // an interrupting signal does not mean that the device is gone
    }
    bool write(std::span<const std::uint8_t> report) noexcept override {
        return hid_write(device_, report.data(), report.size()) == static_cast<int>(report.size());
    }
    int feature(std::span<std::uint8_t> bytes) noexcept override {
        return hid_get_feature_report(device_, bytes.data(), bytes.size());
    }

private:
    DeviceHost& host_;
    hid_device* device_;
};

class SystemBus final : public Bus {
public:
    explicit SystemBus(DeviceHost& host) : host_(host) {}

    std::vector<DeviceInfo> list() override {
        const std::lock_guard lock(host_.bus);
        std::vector<DeviceInfo> devices;
        hid_device_info* const first = hid_enumerate(0, 0);
        for (const hid_device_info* at = first; at != nullptr; at = at->next) {
            DeviceInfo device;
            device.path = at->path != nullptr ? at->path : "";
            device.vendor = at->vendor_id;
            device.product = at->product_id;
            device.usagePage = at->usage_page;
            device.usage = at->usage;
            device.serial = textOf(at->serial_number);
            device.name = textOf(at->product_string);
            // An interface with several collections is listed once for each of them; the first one identifies it.
            if (std::ranges::find(devices, device.path, &DeviceInfo::path) == devices.end())
                devices.push_back(std::move(device));
        }
        hid_free_enumeration(first);
        return devices;
    }

    Result<std::unique_ptr<Port>> open(const DeviceInfo& device) override {
        const std::lock_guard lock(host_.bus);
        errno = 0;
        hid_device* const opened = hid_open_path(device.path.c_str());
        if (opened != nullptr) return std::unique_ptr<Port>(std::make_unique<SystemPort>(host_, opened));
        const bool there = access(device.path.c_str(), F_OK) == 0;
        if (there && access(device.path.c_str(), R_OK | W_OK) != 0)
            return Error{ErrorCode::deviceNotAllowed, device.name, device.path, {}};
        return Error{ErrorCode::deviceNotFound, device.name, {}, textOf(hid_error(nullptr))};
    }

private:
    DeviceHost& host_;
};

std::string plainId(const DeviceInfo& device) {
    char numbers[10];
    std::snprintf(numbers, sizeof numbers, "%04x:%04x", device.vendor, device.product);
    return device.serial.empty() ? numbers : numbers + (":" + device.serial);
}

} // namespace

std::unique_ptr<Bus> systemBus(DeviceHost& host) {
    return std::make_unique<SystemBus>(host);
}

std::string idOf(const DeviceInfo& device, const std::vector<DeviceInfo>& all) {
    const std::string id = plainId(device);
    int place = 1;
    for (const DeviceInfo& other : all)
        if (other.path < device.path && plainId(other) == id) ++place;
    return place == 1 ? id : id + "#" + std::to_string(place);
}

std::vector<DeviceInfo> devicesOn(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted) {
    std::vector<DeviceInfo> devices = bus.list();
    std::erase_if(devices, [&](const DeviceInfo& device) { return !wanted(device); });
    return devices;
}

std::optional<DeviceInfo> deviceWithId(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                       const std::string& id) {
    const std::vector<DeviceInfo> devices = devicesOn(bus, wanted);
    for (const DeviceInfo& device : devices)
        if (idOf(device, devices) == id) return device;
    return std::nullopt;
}

std::unique_ptr<Port> openAgain(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                const std::string& id) noexcept {
    try {
        const std::optional<DeviceInfo> device = deviceWithId(bus, wanted, id);
        if (!device) return nullptr;
        Result<std::unique_ptr<Port>> port = bus.open(*device);
        return port ? std::move(*port) : nullptr;
    } catch (...) {
        return nullptr;
    }
}

} // namespace burin::hid
