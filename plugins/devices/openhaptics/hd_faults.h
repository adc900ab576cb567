// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "plugins/devices/openhaptics/hd_api.h"

#include <optional>
#include <string>

namespace burin::openhaptics {

/// What an error of the servo loop means for the hand; nothing for 0, which is no error. One that is not known counts
/// as a failed drive: its meaning can't be trusted.
std::optional<DeviceFault> faultOf(unsigned int code) noexcept;

/// Why a device could not be connected. @param name of the device
Error connectionError(unsigned int code, const std::string& name);

} // namespace burin::openhaptics
