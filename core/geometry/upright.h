// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace burin {

/// The axis of an upright tool, setup frame.
inline constexpr glm::dvec3 uprightAxis{0.0, 0.0, 1.0};

/// Whether a tool is upright: components within 1e-6, that is, a deviation of 0.1 µm over 100 mm of stick-out. @param
/// axis  unit length
inline bool isUpright(const glm::dvec3& axis) noexcept {
    constexpr double tilt = 1e-6;
    return std::abs(axis.x) < tilt && std::abs(axis.y) < tilt && axis.z > 0.0;
}

} // namespace burin
