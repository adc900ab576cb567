// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/pose_vector.h"

#include "core/base/units.h"
#include "core/geometry/frame_along.h"

namespace burin {

glm::dvec3 turnBetween(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    if (from == to) return glm::dvec3(0.0);
    const glm::dvec3 normal = glm::cross(from, to);
    const double sine = glm::length(normal), cosine = glm::dot(from, to);
    if (sine > 1e-12) return normal * (std::atan2(sine, cosine) / sine);
    if (cosine > 0.0) return normal; // the sine of a small angle equals the angle
    return anyAcross(from) * pi;
}

glm::dvec3 turnBetween(const glm::dquat& from, const glm::dquat& to) noexcept {
    glm::dquat turn = to * glm::conjugate(from);
    if (turn.w < 0.0) turn = -turn; // the shorter rotation
    const glm::dvec3 normal(turn.x, turn.y, turn.z);
    const double sine = glm::length(normal);
    return sine > 1e-12 ? normal * (2.0 * std::atan2(sine, turn.w) / sine) : 2.0 * normal;
}

glm::dvec3 turned(const glm::dvec3& axis, const glm::dvec3& turn) noexcept {
    const glm::dvec3 across = turn - glm::dot(turn, axis) * axis;
    const double angle = glm::length(across);
    if (!(angle > 0.0)) return axis;
    return glm::normalize(std::cos(angle) * axis + (std::sin(angle) / angle) * glm::cross(across, axis));
}

} // namespace burin
