// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <memory>

namespace burin::spacenav {

/// Finds spacenavd, the free daemon for 3D mice, if it runs, and makes a stylus for its data.
std::unique_ptr<DeviceDriver> makeDriver();

} // namespace burin::spacenav
