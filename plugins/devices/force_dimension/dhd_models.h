// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <optional>

namespace burin::forcedimension {

/// What a model of Force Dimension can bear, of those that CHAI3D's table has. Names and freedoms are left to the
/// device. @param type dhdGetSystemType; nothing where it is not known: its forces could not be bounded then.
std::optional<StylusDescription> limitsOf(int type);

/// A pose of the library (m, the rows of a rotation; x towards the user, y right, z up; the pen along its own x, from
/// the tip backwards) in Burin's device frame.
Pose poseOf(double x, double y, double z, const double (&rotation)[3][3]) noexcept;
/// A vector of Burin's device frame in the library's: x towards the user, y right, z up.
glm::dvec3 toDhd(const glm::dvec3& vector) noexcept;

} // namespace burin::forcedimension
