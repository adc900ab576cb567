// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cmath>

namespace burin {

/// The turn from a frame to one whose z lies along an axis; the same axis gives the same one. @param axis unit
inline glm::dmat3 frameAlong(const glm::dvec3& axis) noexcept {
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 y = glm::normalize(glm::cross(axis, other));
    return glm::transpose(glm::dmat3(glm::cross(y, axis), y, axis));
}

/// The box around a turned one.
inline Box boxAround(const Box& box, const glm::dmat3& turn) noexcept {
    Box around;
    for (int i = 0; i < 8; ++i)
        around.include(turn * glm::dvec3(i & 1 ? box.low.x : box.high.x, i & 2 ? box.low.y : box.high.y,
                                         i & 4 ? box.low.z : box.high.z));
    return around;
}

} // namespace burin
