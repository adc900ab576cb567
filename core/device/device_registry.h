// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Id of the stylus that is always there (SimulatedStylus).
inline constexpr const char* simulatedDevice = "simulated";

/// A driver, and what keeps it from its devices.
struct DriverState {
    std::string id, name;
    std::optional<Error> missing; ///< DeviceDriver::ready
};

/// All drivers: the simulated stylus, the user's plugins, and those below plugins/devices that have other ids. A plugin
/// that can't be used costs a message, not the others. Ids of devices begin with that of their driver:
/// "spacemouse:256f:c62e". Any thread; calls take turns, and each may take some milliseconds.
class DeviceRegistry {
public:
    /// Reads what the plugins below `folder` say of themselves; loads those whose interface version is ours.
    /// @param folder default: the user's folder, then devices in pluginDirectory(); need not exist.
    explicit DeviceRegistry(const std::filesystem::path& folder = {});
    DeviceRegistry(const DeviceRegistry&) = delete;
    DeviceRegistry& operator=(const DeviceRegistry&) = delete;

    /// One more driver, for this process. @param id not taken yet
    void add(std::string id, std::unique_ptr<DeviceDriver> driver);
    /// What is there now, the simulated stylus first, then in the order of the drivers' ids.
    std::vector<FoundDevice> scan();
    /// The device with an id, or with a name that only one has. Errors: nameUnknown (detail: the ids that are there;
    /// not the simulated stylus, which nobody needs to look for).
    Result<FoundDevice> find(const std::string& idOrName);
    /// A stylus for a device, connected but not open; it must not outlive the registry. Errors: deviceNotFound, those
    /// of DeviceDriver::make, pluginInvalid (what it says of itself breaks a rule of checkDescription, or it threw).
    Result<AnyStylus> make(const std::string& id, const std::string& mode = {});
    /// The drivers that are loaded, the simulated stylus' first.
    std::vector<DriverState> drivers();
    /// Plugins that could not be used, each told once.
    std::vector<Error> takeFaults();

private:
    struct Entry {
        std::string id, name;
        std::string origin; ///< file, for messages
        std::unique_ptr<DeviceDriver> driver;
    };
    void load(const std::filesystem::path& folder);
    std::vector<FoundDevice> findWith(Entry& entry);

    std::mutex turn_; ///< one call at a time
    std::mutex bus_;  ///< DeviceHost
    DeviceHost host_{bus_};
    std::vector<Entry> entries_;
    std::vector<Error> faults_;
};

} // namespace burin
