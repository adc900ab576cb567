// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace burin::openhaptics {

/// Finds the devices that were configured by 3D Systems' setup program, and makes styluses for them.
std::unique_ptr<DeviceDriver> makeDriver();

/// Names of the configured devices: files "NAME.config" in $GTDD_HOME/config, ~/.3dsystems/config and
/// /usr/share/3DSystems/config, each once, "Default Device" first. libHD has no function to list them.
std::vector<std::string> configuredDevices();

} // namespace burin::openhaptics
