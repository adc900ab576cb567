// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <optional>

namespace burin::forcedimension {

/// The limits of a Force Dimension model, for the models in CHAI3D's table. Name and degrees of freedom are taken from
/// the device. @param type dhdGetSystemType. Empty for an unknown type, whose forces could not be limited.
std::optional<StylusDescription> limitsOf(int type);

/// Converts a pose of the library (m, rows of a rotation matrix; x towards the user, y right, z up; the pen along its
/// own x, from the tip backwards) to Burin's device frame.
Pose poseOf(double x, double y, double z, const double (&rotation)[3][3]) noexcept;
/// Converts a vector from Burin's device frame to the library's: x towards the user, y right, z up.
glm::dvec3 toDhd(const glm::dvec3& vector) noexcept;

} // namespace burin::forcedimension
