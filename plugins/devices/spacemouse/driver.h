// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/hid/hid_bus.h"

#include <memory>

namespace burin::spacemouse {

/// Finds 3D mice on a bus; modes "rate" and "position". The bus lives as long as the driver, and the driver outlives
/// the styluses that it makes.
std::unique_ptr<DeviceDriver> makeDriver(std::unique_ptr<hid::Bus> bus);

} // namespace burin::spacemouse
