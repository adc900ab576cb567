// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cmath>

namespace burin {

/// The frame's axis nearest to a direction: 0, 1, 2 for x, y, z; of equally near ones the last.
inline int nearestAxis(const glm::dvec3& direction) noexcept {
    const glm::dvec3 share = glm::abs(direction);
    return share.z >= share.x && share.z >= share.y ? 2 : share.y >= share.x ? 1 : 0;
}

/// A direction perpendicular to `axis`; deterministic. @param axis  unit
inline glm::dvec3 anyAcross(const glm::dvec3& axis) noexcept {
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(axis, other));
}

/// The rotation from a frame to one whose z axis is parallel to `axis`; deterministic. @param axis  unit
inline glm::dmat3 frameAlong(const glm::dvec3& axis) noexcept {
    const glm::dvec3 y = anyAcross(axis);
    return glm::transpose(glm::dmat3(glm::cross(y, axis), y, axis));
}

/// The bounding box of a rotated box.
inline Box boxAround(const Box& box, const glm::dmat3& turn) noexcept {
    Box around;
    for (unsigned i = 0; i < 8; ++i) around.include(turn * box.corner(i));
    return around;
}

} // namespace burin
