// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <memory>

namespace burin::input_events {

/// Finds the gamepads, joysticks and pen tablets among the kernel's input devices.
std::unique_ptr<DeviceDriver> makeDriver();

} // namespace burin::input_events
