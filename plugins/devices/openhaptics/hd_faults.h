// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "plugins/devices/openhaptics/hd_api.h"

#include <optional>
#include <string>

namespace burin::openhaptics {

/// The device fault for an error of the servo loop; empty for 0, which is not an error. An unknown error counts as a
/// failed drive, because its consequences are not known.
std::optional<DeviceFault> faultOf(unsigned int code) noexcept;

/// The error for a failed connection. @param name name of the device
Error connectionError(unsigned int code, const std::string& name);

} // namespace burin::openhaptics
