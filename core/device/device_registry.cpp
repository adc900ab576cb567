// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_registry.h"

#include "core/base/file.h"
#include "core/base/plugin_library.h"
#include "core/device/simulated_stylus.h"

#include <algorithm>

namespace burin {
namespace {

constexpr PluginKind devicePlugin{"device", "devices", DeviceDriver::interfaceVersion, {}};

Error invalid(const std::string& origin, std::string detail) {
    return {ErrorCode::pluginInvalid, origin, {}, std::move(detail)};
}

class SimulatedDriver final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override { return {{{}, SimulatedStylus(origin).description().name, {}}}; }
    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!id.empty()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        if (!mode.empty()) return Error{ErrorCode::nameUnknown, "stylus", mode, {}};
        return AnyStylus(std::make_unique<SimulatedStylus>(origin));
    }

private:
    static constexpr glm::dvec3 origin{0.0};
};

/// Exceptions of a plugin's code must not reach Burin.
template <class Answer, class Call>
Result<Answer> guarded(const std::string& origin, const Call& call) {
    try {
        return call();
    } catch (const std::exception& fault) {
        return invalid(origin, std::string("it threw: ") + fault.what());
    } catch (...) {
        return invalid(origin, "it threw");
    }
}

/// Data of a plugin that was built with other headers than Burin's would be read wrongly.
Result<void> checkLayout(const PluginDescription& plugin) {
    const Result<void*> symbol = loadPlugin(devicePlugin, plugin, deviceLayoutPoint);
    if (!symbol) return symbol.error();
    std::uint32_t count = 0;
    const TypeLayout* layout = reinterpret_cast<DeviceLayout>(*symbol)(&count);
    const std::string origin = plugin.library.string();
    if (layout == nullptr || count != deviceLayout.size()) return invalid(origin, "built with other headers of Burin");
    for (std::size_t i = 0; i < deviceLayout.size(); ++i)
        if (layout[i].size != deviceLayout[i].size || layout[i].alignment != deviceLayout[i].alignment)
            return invalid(origin, std::string("built with another ") + deviceLayout[i].type + ": " +
                                       std::to_string(layout[i].size) + " bytes in it, " +
                                       std::to_string(deviceLayout[i].size) + " in Burin");
    return {};
}

Result<std::unique_ptr<DeviceDriver>> createDriver(const PluginDescription& plugin, DeviceHost& host) {
    const Result<void> fits = checkLayout(plugin);
    if (!fits) return fits.error();
    const Result<void*> symbol = loadPlugin(devicePlugin, plugin, deviceEntryPoint);
    if (!symbol) return symbol.error();
    const auto function = reinterpret_cast<CreateDeviceDriver>(*symbol); // POSIX: dlsym returns functions as void*
    auto driver = guarded<std::unique_ptr<DeviceDriver>>(
        plugin.library.string(), [&]() { return std::unique_ptr<DeviceDriver>(function(host)); });
    if (driver && *driver == nullptr) return invalid(plugin.library.string(), "its entry point gave nothing");
    return driver;
}

StylusDevice* deviceOf(const AnyStylus& stylus) {
    return std::visit([](const auto& held) -> StylusDevice* { return held.get(); }, stylus);
}

} // namespace

DeviceRegistry::DeviceRegistry(const std::filesystem::path& folder) {
    entries_.push_back({simulatedDevice, simulatedDevice, simulatedDevice, std::make_unique<SimulatedDriver>()});
    if (folder.empty()) load(userPluginDirectory(devicePlugin));
    load(folder.empty() ? pluginDirectory() / devicePlugin.folder : folder);
}

void DeviceRegistry::load(const std::filesystem::path& folder) {
    if (folder.empty()) return;
    const auto plugins = findPlugins(devicePlugin, folder, &faults_);
    if (!plugins) {
        if (plugins.error().code != ErrorCode::fileNotFound) faults_.push_back(plugins.error());
        return;
    }
    for (const PluginDescription& plugin : *plugins) {
        // the user's plugin takes precedence
        if (std::ranges::find(entries_, plugin.id, &Entry::id) != entries_.end()) continue;
        auto driver = createDriver(plugin, host_);
        if (driver)
            entries_.push_back({plugin.id, plugin.name, plugin.library.string(), std::move(*driver)});
        else
            faults_.push_back(std::move(driver).error());
    }
}

void DeviceRegistry::add(std::string id, std::unique_ptr<DeviceDriver> driver) {
    const std::lock_guard turn(turn_);
    entries_.push_back({id, id, id, std::move(driver)});
}

std::vector<FoundDevice> DeviceRegistry::findWith(Entry& entry) {
    auto devices = guarded<std::vector<FoundDevice>>(entry.origin, [&]() { return entry.driver->find(); });
    if (!devices) {
        faults_.push_back(std::move(devices).error());
        return {};
    }
    for (FoundDevice& device : *devices) device.id = device.id.empty() ? entry.id : entry.id + ":" + device.id;
    return std::move(*devices);
}

std::vector<FoundDevice> DeviceRegistry::scan() {
    const std::lock_guard turn(turn_);
    std::vector<FoundDevice> all;
    for (Entry& entry : entries_)
        for (FoundDevice& device : findWith(entry)) all.push_back(std::move(device));
    return all;
}

Result<FoundDevice> DeviceRegistry::find(const std::string& idOrName) {
    std::vector<FoundDevice> devices = scan();
    std::erase_if(devices, [](const FoundDevice& device) { return device.id == simulatedDevice; });
    if (const auto found = std::ranges::find(devices, idOrName, &FoundDevice::id); found != devices.end())
        return *found;
    if (std::ranges::count(devices, idOrName, &FoundDevice::name) == 1)
        return *std::ranges::find(devices, idOrName, &FoundDevice::name);
    std::string there;
    for (const FoundDevice& device : devices) there += (there.empty() ? "" : ", ") + device.id;
    return Error{ErrorCode::nameUnknown, "device", idOrName, there};
}

Result<AnyStylus> DeviceRegistry::make(const std::string& id, const std::string& mode) {
    const std::lock_guard turn(turn_);
    const std::string driver = id.substr(0, id.find(':'));
    const auto entry = std::ranges::find(entries_, driver, &Entry::id);
    if (entry == entries_.end()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
    const std::string within = driver.size() == id.size() ? std::string() : id.substr(driver.size() + 1);
    auto made = guarded<AnyStylus>(entry->origin, [&]() { return entry->driver->make(within, mode); });
    if (!made) return made;
    StylusDevice* device = deviceOf(*made);
    if (device == nullptr) return invalid(entry->origin, "it made nothing");
    const Result<void> checked = checkDescription(device->description());
    if (!checked) return invalid(entry->origin, checked.error().place + ": " + checked.error().detail);
    return made;
}

std::vector<DriverState> DeviceRegistry::drivers() {
    const std::lock_guard turn(turn_);
    std::vector<DriverState> states;
    for (Entry& entry : entries_) {
        const auto ready = guarded<void>(entry.origin, [&]() { return entry.driver->ready(); });
        states.push_back({entry.id, entry.name, ready ? std::nullopt : std::optional(ready.error())});
    }
    return states;
}

std::vector<Error> DeviceRegistry::takeFaults() {
    const std::lock_guard turn(turn_);
    return std::exchange(faults_, {});
}

} // namespace burin
