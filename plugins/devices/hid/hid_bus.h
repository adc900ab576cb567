// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// A narrow interface to hidapi, shared by the plugins for HID devices, so that everything above it can be tested
/// without a bus.
namespace burin::hid {

/// One interface of a device on the bus.
struct DeviceInfo {
    std::string path; ///< path in the system: "/dev/hidraw0"; changes each time the device is plugged in
    std::uint16_t vendor = 0, product = 0;
    std::uint16_t usagePage = 0, usage = 0; ///< of its first application collection; 0: not known
    std::string serial;                     ///< empty if it has none
    std::string name;                       ///< product name reported by the device; may be empty
};

/// An open interface. Functions are called on one thread; they access only the device, and do not allocate unless they
/// fail.
class Port {
public:
    virtual ~Port() = default;
    /// Reads the next input report, including its id. @return its size; 0 if none arrived in time; -1 if the device is
    /// gone.
    virtual int read(std::span<std::uint8_t> bytes, int milliseconds) noexcept = 0;
    /// Sends an output report, including its id. Returns false if the device did not accept it.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    /// Reads a feature report. @param bytes the first byte is its id. @return its size including the id; -1 if there is
    /// none.
    virtual int feature(std::span<std::uint8_t> bytes) noexcept = 0;
};

/// Thread-safe.
class Bus {
public:
    virtual ~Bus() = default;
    virtual std::vector<DeviceInfo> list() = 0;
    /// Errors: deviceNotAllowed, deviceNotFound.
    virtual Result<std::unique_ptr<Port>> open(const DeviceInfo& device) = 0;
};

/// The system's bus, through hidapi (hidraw on Linux). Holds the host's lock while it lists, opens and closes devices.
std::unique_ptr<Bus> systemBus(DeviceHost& host);

/// "256f:c62e" or "256f:c62e:SERIAL": a device gets the same id again. If there are several without a serial number,
/// "#2" is appended for the second one.
std::string idOf(const DeviceInfo& device, const std::vector<DeviceInfo>& all);

/// The device with an id among those that `wanted` accepts; empty if it is not connected.
std::optional<DeviceInfo> deviceWithId(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                       const std::string& id);

/// Opens the device with an id; null if it is not connected or must not be opened, and when memory runs out. Allocates
/// and takes the host's lock: not to be called while the device is read.
std::unique_ptr<Port> openAgain(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                const std::string& id) noexcept;

/// The devices that `wanted` accepts.
std::vector<DeviceInfo> devicesOn(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted);

} // namespace burin::hid
