// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <memory>

namespace burin::haply {

/// Finds the Inverse3 devices that are managed by Haply's service, and makes styluses for them.
std::unique_ptr<DeviceDriver> makeDriver();

} // namespace burin::haply
