// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "plugins/devices/openhaptics/hd_api.h"

#include <array>
#include <string>

namespace burin::openhaptics {

/// The description that the current device gives of itself. @param name name of the device, for messages. Errors:
/// deviceFault (its limits are not values that a force could be scaled by).
Result<StylusDescription> describeCurrent(const HdApi& api, const std::string& name);

/// Converts a transform of libHD (16 numbers in column order, mm; x right, y up, z towards the user; the pen's own z
/// from its tip backwards) to a pose in Burin's device frame. Invalid numbers give a pose that is not finite.
Pose poseOf(const std::array<double, 16>& transform) noexcept;
/// Converts a force or torque from Burin's device frame to libHD's.
std::array<double, 3> toHd(const glm::dvec3& vector) noexcept;

} // namespace burin::openhaptics
