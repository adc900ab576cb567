// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/hid/hid_bus.h"

#include <memory>

namespace burin::openstylus {

/// Finds the devices on a bus that use the open stylus protocol. The bus lives as long as the driver, and the driver
/// outlives the styluses that it makes.
std::unique_ptr<DeviceDriver> makeDriver(std::unique_ptr<hid::Bus> bus);

} // namespace burin::openstylus
