// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cmath>

namespace burin {

/// The frame's axis that a direction lies nearest to: 0, 1, 2 for x, y, z; of equal ones the last.
inline int nearestAxis(const glm::dvec3& direction) noexcept {
    const glm::dvec3 share = glm::abs(direction);
    return share.z >= share.x && share.z >= share.y ? 2 : share.y >= share.x ? 1 : 0;
}

/// A direction square to one; the same one for the same. @param axis unit
inline glm::dvec3 anyAcross(const glm::dvec3& axis) noexcept {
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(axis, other));
}

/// The turn from a frame to one whose z lies along an axis; the same axis gives the same one. @param axis unit
inline glm::dmat3 frameAlong(const glm::dvec3& axis) noexcept {
    const glm::dvec3 y = anyAcross(axis);
    return glm::transpose(glm::dmat3(glm::cross(y, axis), y, axis));
}

/// The box around a turned one.
inline Box boxAround(const Box& box, const glm::dmat3& turn) noexcept {
    Box around;
    for (unsigned i = 0; i < 8; ++i) around.include(turn * box.corner(i));
    return around;
}

} // namespace burin
