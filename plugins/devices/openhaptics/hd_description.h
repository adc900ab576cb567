// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "plugins/devices/openhaptics/hd_api.h"

#include <array>
#include <string>

namespace burin::openhaptics {

/// What the current device says of itself. @param name of the device, for messages. Errors: deviceFault (its limits are
/// not numbers that a force could be scaled by).
Result<StylusDescription> describeCurrent(const HdApi& api, const std::string& name);

/// The pose of a transform of libHD (16 numbers by columns, mm; x right, y up, z towards the user; the pen's own z from
/// its tip backwards) in Burin's device frame. Not valid numbers give a pose that is not finite.
Pose poseOf(const std::array<double, 16>& transform) noexcept;
/// A force or torque of Burin's device frame, as libHD takes it.
std::array<double, 3> toHd(const glm::dvec3& vector) noexcept;

} // namespace burin::openhaptics
