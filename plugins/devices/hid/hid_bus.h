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

/// What the plugins for HID devices share: a narrow seam over hidapi, so that everything above it can be tested without
/// a bus.
namespace burin::hid {

/// One interface of a device on the bus.
struct DeviceInfo {
    std::string path; ///< of the system: "/dev/hidraw0"; another one after each plugging in
    std::uint16_t vendor = 0, product = 0;
    std::uint16_t usagePage = 0, usage = 0; ///< of its first application collection; 0: not known
    std::string serial;                     ///< empty: it has none
    std::string name;                       ///< product, as it calls itself; may be empty
};

/// An open interface. Functions on one thread; they talk to the device and nothing else, and allocate nothing unless
/// they fail.
class Port {
public:
    virtual ~Port() = default;
    /// The next input report with its id. @return its size; 0 when none came in time; -1 when the device is gone.
    virtual int read(std::span<std::uint8_t> bytes, int milliseconds) noexcept = 0;
    /// An output report with its id. False when the device did not take it.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    /// A feature report. @param bytes the first one is its id. @return its size with the id; -1 when there is none.
    virtual int feature(std::span<std::uint8_t> bytes) noexcept = 0;
};

/// Any thread.
class Bus {
public:
    virtual ~Bus() = default;
    virtual std::vector<DeviceInfo> list() = 0;
    /// Errors: deviceNotAllowed, deviceNotFound.
    virtual Result<std::unique_ptr<Port>> open(const DeviceInfo& device) = 0;
};

/// The system's bus, through hidapi (hidraw on Linux). Holds the host's lock while it lists, opens and closes.
std::unique_ptr<Bus> systemBus(DeviceHost& host);

/// "256f:c62e" or "256f:c62e:SERIAL": the same device has the same one again. Of several without a serial number the
/// second has "#2" at its end.
std::string idOf(const DeviceInfo& device, const std::vector<DeviceInfo>& all);

/// The device of an id among those that `wanted` accepts; nothing when it is not there.
std::optional<DeviceInfo> deviceWithId(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                       const std::string& id);

/// Opens the device of an id where it is there and may be opened; null otherwise, and when memory runs out. Allocates,
/// takes the host's lock: not while the device is read.
std::unique_ptr<Port> openAgain(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted,
                                const std::string& id) noexcept;

/// The devices that `wanted` accepts.
std::vector<DeviceInfo> devicesOn(Bus& bus, const std::function<bool(const DeviceInfo&)>& wanted);

} // namespace burin::hid
