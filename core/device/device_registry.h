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

/// Id of the stylus that is always available (SimulatedStylus).
inline constexpr const char* simulatedDevice = "simulated";

/// A driver and, if it can't be used, the reason.
struct DriverState {
    std::string id, name;
    std::optional<Error> missing; ///< DeviceDriver::ready
};

/// All drivers: the simulated stylus, the user's plugins, and those plugins below plugins/devices whose ids the user's
/// do not have. A plugin that can't be used leads to a message; the others are still loaded. Ids of devices begin with
/// the id of their driver: "spacemouse:256f:c62e". Thread-safe: calls are serialised, and each may take some
/// milliseconds.
class DeviceRegistry {
public:
    /// Reads the metadata of the plugins below `folder` and loads those whose interface version is Burin's.
    /// @param folder default: the user's folder, then devices in pluginDirectory(); need not exist.
    explicit DeviceRegistry(const std::filesystem::path& folder = {});
    DeviceRegistry(const DeviceRegistry&) = delete;
    DeviceRegistry& operator=(const DeviceRegistry&) = delete;

    /// Adds a driver, for this process. @param id not used by another driver
    void add(std::string id, std::unique_ptr<DeviceDriver> driver);
    /// The devices that are connected now: the simulated stylus first, then the others in the order of their drivers'
    /// ids.
    std::vector<FoundDevice> scan();
    /// The device with this id, or the only one with this name. Errors: nameUnknown (detail: the ids of the connected
    /// devices, without the simulated stylus, which is always available).
    Result<FoundDevice> find(const std::string& idOrName);
    /// Makes a stylus for a device: connected but not open. It must not outlive the registry. Errors: deviceNotFound,
    /// those of DeviceDriver::make, pluginInvalid (its description breaks a rule of checkDescription, or it threw an
    /// exception).
    Result<AnyStylus> make(const std::string& id, const std::string& mode = {});
    /// The drivers that are loaded, that of the simulated stylus first.
    std::vector<DriverState> drivers();
    /// The errors of plugins that could not be used. Each is reported once.
    std::vector<Error> takeFaults();

private:
    struct Entry {
        std::string id, name;
        std::string origin; ///< file name, for messages
        std::unique_ptr<DeviceDriver> driver;
    };
    void load(const std::filesystem::path& folder);
    std::vector<FoundDevice> findWith(Entry& entry);

    std::mutex turn_; ///< serialises the public functions
    std::mutex bus_;  ///< DeviceHost
    DeviceHost host_{bus_};
    std::vector<Entry> entries_;
    std::vector<Error> faults_;
};

} // namespace burin
