// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_driver.h"

namespace burin::cap {
namespace {

constexpr const char* rate = "rate";
constexpr const char* position = "position";

} // namespace

std::vector<DeviceMode> modes() {
    return {{rate, BURIN_TEXT("Device", "The cap sets the speed")},
            {position, BURIN_TEXT("Device", "The cap sets the position")}};
}

Result<void> checkMode(const std::string& mode) {
    if (mode.empty() || mode == rate || mode == position) return {};
    return Error{ErrorCode::nameUnknown, "stylus", mode, std::string(rate) + ", " + position};
}

ControlMode modeOf(const std::string& mode) {
    return mode == position ? ControlMode::position : ControlMode::rate;
}

} // namespace burin::cap
