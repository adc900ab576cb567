// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/driver.h"

#include "plugins/devices/openhaptics/hd_stylus.h"
#include "plugins/devices/vendor/late_api.h"
#include "plugins/devices/vendor/vendor_library.h"

#include <algorithm>
#include <system_error>

namespace burin::openhaptics {
namespace {

namespace fs = std::filesystem;

constexpr const char* usualDevice = "Default Device"; // the first device of the setup program
constexpr const char* suffix = ".config";

std::vector<fs::path> configurationFolders() {
    std::vector<fs::path> folders;
    if (const fs::path home = vendor::folderFrom("GTDD_HOME"); !home.empty()) folders.push_back(home / "config");
    if (const fs::path home = vendor::folderFrom("HOME"); !home.empty())
        folders.push_back(home / ".3dsystems" / "config");
    folders.emplace_back("/usr/share/3DSystems/config");
    return folders;
}

class Driver final : public DeviceDriver {
public:
    Result<void> ready() override {
        const Result<const HdApi*> api = api_.get();
        if (!api) return api.error();
        return {};
    }

    std::vector<FoundDevice> find() override {
        std::vector<FoundDevice> found;
        if (!api_.get()) return found;
        for (const std::string& name : configuredDevices()) found.push_back({name, "3D Systems: " + name, {}});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!mode.empty()) return Error{ErrorCode::nameUnknown, "stylus", mode, {}};
        const Result<const HdApi*> api = api_.get();
        if (!api) return api.error();
        const std::vector<std::string> names = configuredDevices();
        const auto name = std::ranges::find(names, id);
        if (name == names.end()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        if (library_ == nullptr) library_ = std::make_shared<HdLibrary>(**api);
        auto stylus = HdStylus::connect(library_, *name);
        if (!stylus) return stylus.error();
        return AnyStylus(std::move(*stylus));
    }

private:
    vendor::LateApi<HdApi> api_{loadHdApi};
    std::shared_ptr<HdLibrary> library_;
};

} // namespace

std::vector<std::string> configuredDevices() {
    std::vector<std::string> names;
    for (const fs::path& folder : configurationFolders()) {
        std::error_code fault;
        for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault))
            if (at->path().extension() == suffix) names.push_back(at->path().stem().string());
    }
    std::ranges::sort(names, {}, [](const std::string& name) { return std::pair(name != usualDevice, name); });
    const auto rest = std::ranges::unique(names);
    names.erase(rest.begin(), rest.end());
    return names;
}

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::openhaptics
