// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"
#include "core/device/stylus.h"

#include <array>
#include <cstdint>
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
    static constexpr int interfaceVersion = 5; ///< +1 with any change to this header or to stylus.h
    virtual ~DeviceDriver() = default;
    /// What keeps it from any device at all: a library of their maker that is not installed, or is too old; success
    /// where nothing does. Errors: deviceLibraryMissing, deviceLibraryUnfit.
    virtual Result<void> ready() { return {}; }
    /// Those that are plugged in now, also those that may not be opened.
    virtual std::vector<FoundDevice> find() = 0;
    /// A stylus for a device, connected (its description is its own) but not open yet. One for a device at a time.
    /// @param mode id of one of its modes; empty: the usual one.
    /// Errors: deviceNotFound, deviceNotAllowed, deviceIncompatible, deviceFault, nameUnknown (the mode).
    virtual Result<AnyStylus> make(const std::string& id, const std::string& mode) = 0;
};

/// A device plugin is a folder in plugins/devices with plugin.json ({"id", "kind": "device", "name", "version",
/// "interface_version", "library"}) and the library it names, which exports the two functions of BURIN_DEVICE_PLUGIN.
/// Metadata is read, and the interface version compared, before any code of the plugin runs; then the layout of what
/// passes between plugin and Burin, as a plugin may be built with other headers than it says.
inline constexpr const char* deviceEntryPoint = "burinCreateDeviceDriver";
using CreateDeviceDriver = DeviceDriver* (*)(DeviceHost& host); ///< the caller owns the object and deletes it
inline constexpr const char* deviceLayoutPoint = "burinDeviceLayout";

/// Bytes of a type that passes between plugin and Burin, as a compiler laid it out.
struct TypeLayout {
    const char* type;
    std::uint32_t size, alignment;
};
template <class Type>
constexpr TypeLayout layoutOf(const char* name) noexcept {
    return {name, sizeof(Type), alignof(Type)};
}
inline constexpr std::array deviceLayout{layoutOf<std::string>("std::string"),
                                         layoutOf<Error>("Error"),
                                         layoutOf<FoundDevice>("FoundDevice"),
                                         layoutOf<DeviceMode>("DeviceMode"),
                                         layoutOf<DeviceHost>("DeviceHost"),
                                         layoutOf<StylusDescription>("StylusDescription"),
                                         layoutOf<StylusState>("StylusState"),
                                         layoutOf<Wrench>("Wrench"),
                                         layoutOf<DeviceHealth>("DeviceHealth"),
                                         layoutOf<AnyStylus>("AnyStylus"),
                                         layoutOf<Result<AnyStylus>>("Result<AnyStylus>"),
                                         layoutOf<Result<void>>("Result<void>")};
/// The entries of deviceLayout, and how many. @param[out] count
using DeviceLayout = const TypeLayout* (*)(std::uint32_t* count);

/// Exports what makes a library a device plugin. @param makeDriver function of a DeviceHost& that gives a
/// std::unique_ptr<DeviceDriver>
#define BURIN_DEVICE_PLUGIN(makeDriver)                                                                                \
    extern "C" [[gnu::visibility("default")]] burin::DeviceDriver* burinCreateDeviceDriver(burin::DeviceHost& host) {  \
        return (makeDriver)(host).release();                                                                           \
    }                                                                                                                  \
    extern "C" [[gnu::visibility("default")]] const burin::TypeLayout* burinDeviceLayout(std::uint32_t* count) {       \
        *count = static_cast<std::uint32_t>(burin::deviceLayout.size());                                               \
        return burin::deviceLayout.data();                                                                             \
    }

} // namespace burin
