// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"
#include "plugins/devices/cap/cap_mapping.h"

#include <string>
#include <vector>

namespace burin::cap {

/// The two modes of a cap, for every driver of a device with a cap.
std::vector<DeviceMode> modes();
/// Errors: nameUnknown. @param mode empty: the default mode
Result<void> checkMode(const std::string& mode);
ControlMode modeOf(const std::string& mode);

} // namespace burin::cap
