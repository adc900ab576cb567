// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <memory>

namespace burin::spacenav {

/// Finds the free daemon of 3D mice, spacenavd, where it runs, and makes a stylus of what it reads.
std::unique_ptr<DeviceDriver> makeDriver();

} // namespace burin::spacenav
