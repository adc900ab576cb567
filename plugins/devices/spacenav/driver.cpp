// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacenav/driver.h"

#include "plugins/devices/cap/cap_driver.h"
#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/spacenav/daemon_socket.h"

namespace burin::spacenav {
namespace {

constexpr const char* daemonId = "daemon";
constexpr int buttons = 32; // the daemon does not report which buttons exist before one is pressed

class Driver final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override {
        if (!daemonRuns()) return {};
        return {{daemonId, "3D mouse (spacenavd)", cap::modes()}};
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (const Result<void> known = cap::checkMode(mode); !known) return known.error();
        auto daemon = std::make_unique<DaemonSocket>();
        if (id != daemonId || !daemon->connect()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        cap::CapStylusSettings settings;
        settings.name = "3D mouse (spacenavd)";
        settings.buttons = buttons;
        settings.mode = cap::modeOf(mode);
        return AnyStylus(
            std::unique_ptr<Stylus>(std::make_unique<cap::CapStylus>(std::move(daemon), std::move(settings))));
    }
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::spacenav
