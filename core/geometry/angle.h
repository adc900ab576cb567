// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace burin {

/// The angle between two vectors of any length, rad, 0 … pi; accurate for small angles, too. 0 if one of them is zero.
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns `from` rotated towards `to` by at most an angle, rad. All vectors of unit length.
glm::dvec3 turnedTowards(const glm::dvec3& from, const glm::dvec3& to, double most) noexcept;

} // namespace burin
