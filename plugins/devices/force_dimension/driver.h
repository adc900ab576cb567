// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <memory>

namespace burin::forcedimension {

/// Finds the devices that libdrd supports (delta, omega, sigma, lambda, Falcon), and makes styluses for them.
std::unique_ptr<DeviceDriver> makeDriver();

} // namespace burin::forcedimension
