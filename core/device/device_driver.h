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

/// A mode of operation, for devices that have several.
struct DeviceMode {
    std::string id;
    TextId name;
};

/// A device that is connected now. `id` identifies the same device after it was plugged in again.
struct FoundDevice {
    std::string id;
    std::string name;
    std::vector<DeviceMode> modes; ///< the first one is the default; empty: nothing to choose
};

/// A stylus of either kind.
using AnyStylus = std::variant<std::unique_ptr<Stylus>, std::unique_ptr<SelfPacedStylus>>;

/// What Burin provides to a driver. Outlives the driver and every object that the driver makes.
struct DeviceHost {
    /// Locked while devices are searched, opened or closed: libraries for a bus (hidapi) keep process-wide state that
    /// several drivers share and that is not thread-safe. Never held while a device is read or written.
    std::mutex& bus;
};

/// Finds and makes the styluses of one kind of hardware. All functions may be called on any thread, but only one at a
/// time; each may take some milliseconds. Lives until the process ends.
class DeviceDriver {
public:
    static constexpr int interfaceVersion =
        7; ///< +1 with any change to this header, to stylus.h, assist.h or axis_map.h
    virtual ~DeviceDriver() = default;
    /// Whether the driver can be used; the error says why it can't use any device: a library of the manufacturer that
    /// is not installed or is too old. Errors: deviceLibraryMissing, deviceLibraryUnfit.
    virtual Result<void> ready() { return {}; }
    /// The devices that are plugged in now, including those that the user has no permission to open.
    virtual std::vector<FoundDevice> find() = 0;
    /// Makes a stylus for a device: connected, so that its description is that of the actual device, but not open yet.
    /// At most one stylus per device at a time.
    /// @param mode id of one of its modes; empty: the default mode.
    /// Errors: deviceNotFound, deviceNotAllowed, deviceIncompatible, deviceFault, nameUnknown (the mode).
    virtual Result<AnyStylus> make(const std::string& id, const std::string& mode) = 0;
};

/// A device plugin is a folder in plugins/devices with plugin.json ({"id", "kind": "device", "name", "version",
/// "interface_version", "library"}) and the library it names, which exports the two functions of BURIN_DEVICE_PLUGIN.
/// The metadata is read and the interface version compared before any code of the plugin runs. Then the memory layout
/// of the types exchanged between plugin and Burin is compared, as a plugin may have been built with other headers than
/// its interface version says.
inline constexpr const char* deviceEntryPoint = "burinCreateDeviceDriver";
using CreateDeviceDriver = DeviceDriver* (*)(DeviceHost& host); ///< the caller owns the object and deletes it
inline constexpr const char* deviceLayoutPoint = "burinDeviceLayout";

/// Size and alignment, in bytes, of a type exchanged between plugin and Burin, as a compiler laid it out.
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
                                         layoutOf<AssistAbilities>("AssistAbilities"),
                                         layoutOf<Assist>("Assist"),
                                         layoutOf<StylusState>("StylusState"),
                                         layoutOf<Wrench>("Wrench"),
                                         layoutOf<DeviceAxis>("DeviceAxis"),
                                         layoutOf<AxisMap>("AxisMap"),
                                         layoutOf<AxisReading>("AxisReading"),
                                         layoutOf<DeviceHealth>("DeviceHealth"),
                                         layoutOf<AnyStylus>("AnyStylus"),
                                         layoutOf<Result<AnyStylus>>("Result<AnyStylus>"),
                                         layoutOf<Result<void>>("Result<void>")};
/// Returns the entries of deviceLayout. @param[out] count number of entries
using DeviceLayout = const TypeLayout* (*)(std::uint32_t* count);

/// Exports the functions that make a library a device plugin. @param makeDriver function that takes a DeviceHost& and
/// returns a std::unique_ptr<DeviceDriver>
#define BURIN_DEVICE_PLUGIN(makeDriver)                                                                                \
    extern "C" [[gnu::visibility("default")]] burin::DeviceDriver* burinCreateDeviceDriver(burin::DeviceHost& host) {  \
        return (makeDriver)(host).release();                                                                           \
    }                                                                                                                  \
    extern "C" [[gnu::visibility("default")]] const burin::TypeLayout* burinDeviceLayout(std::uint32_t* count) {       \
        *count = static_cast<std::uint32_t>(burin::deviceLayout.size());                                               \
        return burin::deviceLayout.data();                                                                             \
    }

} // namespace burin
