// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"
#include "plugins/devices/cap/cap_mapping.h"

#include <string>
#include <vector>

namespace burin::cap {

/// The two ways to use a cap, of every driver of one.
std::vector<DeviceMode> modes();
/// Errors: nameUnknown. @param mode empty: the usual one
Result<void> checkMode(const std::string& mode);
ControlMode modeOf(const std::string& mode);

} // namespace burin::cap
