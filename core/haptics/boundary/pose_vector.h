// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cmath>

namespace burin {

/// A small change of a tool's pose, or a direction among them: a move of the tip, and a turn about the tip (rotation
/// vector, square to the axis) whose angle is measured as an arc, so that both are lengths and have one metric.
struct PoseVector {
    glm::dvec3 move{0.0}; ///< mm
    glm::dvec3 turn{0.0}; ///< mm: rad times a turn length

    friend PoseVector operator+(const PoseVector& a, const PoseVector& b) noexcept {
        return {a.move + b.move, a.turn + b.turn};
    }
    friend PoseVector operator-(const PoseVector& a, const PoseVector& b) noexcept {
        return {a.move - b.move, a.turn - b.turn};
    }
    friend PoseVector operator*(const PoseVector& a, double factor) noexcept {
        return {a.move * factor, a.turn * factor};
    }
};

inline double dot(const PoseVector& a, const PoseVector& b) noexcept {
    return glm::dot(a.move, b.move) + glm::dot(a.turn, b.turn);
}
inline double length(const PoseVector& a) noexcept {
    return std::sqrt(dot(a, a));
}

/// The least turn that takes one axis to another, both of unit length: rotation vector, rad. Axes that point opposite
/// ways turn about some normal of them.
glm::dvec3 turnBetween(const glm::dvec3& from, const glm::dvec3& to) noexcept;
/// The turn that takes one rotation, of unit length, to another: rotation vector, rad, at most pi long.
glm::dvec3 turnBetween(const glm::dquat& from, const glm::dquat& to) noexcept;
/// An axis, turned. @param turn rotation vector, rad; its part along the axis does nothing. @return unit length
glm::dvec3 turned(const glm::dvec3& axis, const glm::dvec3& turn) noexcept;

} // namespace burin
