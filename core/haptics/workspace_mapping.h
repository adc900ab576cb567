// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

namespace burin {

/// Maps the device frame to the setup frame: tip = origin + scale · (rotation · device position).
struct WorkspaceMapping {
    glm::dvec3 origin{0.0}; ///< mm, setup frame: position of the device's zero
    glm::dquat rotation = glm::dquat(1.0, 0.0, 0.0, 0.0);
    double scale = 1.0; ///< mm of setup per mm of device, > 0

    glm::dvec3 toSetup(const glm::dvec3& device) const noexcept { return origin + rotation * device * scale; }
    glm::dvec3 toDevice(const glm::dvec3& setup) const noexcept {
        return glm::conjugate(rotation) * (setup - origin) / scale;
    }
    /// For directions and forces: rotated, not scaled.
    glm::dvec3 directionToSetup(const glm::dvec3& device) const noexcept { return rotation * device; }
    glm::dvec3 directionToDevice(const glm::dvec3& setup) const noexcept { return glm::conjugate(rotation) * setup; }
};

} // namespace burin
