// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"
#include "core/device/stylus.h"

#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

namespace burin {

/// A way to use a device that can be used in several.
struct DeviceMode {
    std::string id;
    TextId name;
};

/// A device that is there now. `id` names the same device after it was plugged in again.
struct FoundDevice {
    std::string id;
    std::string name;
    std::vector<DeviceMode> modes; ///< the first one is the usual; empty: there is nothing to choose
};

/// Either kind of stylus.
using AnyStylus = std::variant<std::unique_ptr<Stylus>, std::unique_ptr<SelfPacedStylus>>;

/// What Burin lends a driver; outlives it and what it makes.
struct DeviceHost {
    /// Held by whoever looks for devices, opens or closes one: libraries for a bus (hidapi) keep process-wide state
    /// that several drivers share and that is not thread-safe. Never held while a device is read or written.
    std::mutex& bus;
};

/// Finds and makes the styluses of one kind of hardware. All functions on any thread, one at a time; each may take some
/// milliseconds. Lives until the process ends.
class DeviceDriver {
public:
    static constexpr int interfaceVersion = 4; ///< +1 with any change to this header or to stylus.h
    virtual ~DeviceDriver() = default;
    /// Those that are plugged in now, also those that may not be opened.
    virtual std::vector<FoundDevice> find() = 0;
    /// A stylus for a device, connected (its description is its own) but not open yet. One for a device at a time.
    /// @param mode id of one of its modes; empty: the usual one.
    /// Errors: deviceNotFound, deviceNotAllowed, deviceIncompatible, deviceFault, nameUnknown (the mode).
    virtual Result<AnyStylus> make(const std::string& id, const std::string& mode) = 0;
};

/// A device plugin is a folder in plugins/devices with plugin.json ({"id", "kind": "device", "name", "version",
/// "interface_version", "library"}) and the library it names, which exports this one function. Metadata is read, and
/// the interface version compared, before any code of the plugin runs.
inline constexpr const char* deviceEntryPoint = "burinCreateDeviceDriver";
using CreateDeviceDriver = DeviceDriver* (*)(DeviceHost& host); ///< the caller owns the object and deletes it

} // namespace burin
