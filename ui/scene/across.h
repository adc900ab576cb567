// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace burin {

/// Two unit directions perpendicular to an axis and to each other; together with the axis as the third they are
/// right-handed.
struct Across {
    glm::dvec3 x, y;
};
/// @param axis unit
inline Across acrossOf(const glm::dvec3& axis) noexcept {
    const glm::dvec3 aside = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 x = glm::normalize(aside - axis * glm::dot(aside, axis));
    return {x, glm::cross(axis, x)};
}

} // namespace burin
