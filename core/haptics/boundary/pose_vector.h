// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cmath>

namespace burin {

/// A small change of a tool's pose, or a direction of change: a translation of the tip, and a rotation about the tip
/// (rotation vector, perpendicular to the axis) whose angle is measured as an arc length, so that both are lengths with
/// a common metric.
struct PoseVector {
    glm::dvec3 move{0.0}; ///< mm
    glm::dvec3 turn{0.0}; ///< mm: rad times the turn length

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

/// The smallest rotation that takes one axis to another, both of unit length: rotation vector, rad. Opposite axes are
/// rotated about an arbitrary normal of them.
glm::dvec3 turnBetween(const glm::dvec3& from, const glm::dvec3& to) noexcept;
/// The rotation that takes one orientation (unit quaternion) to another: rotation vector, rad, at most pi long.
glm::dvec3 turnBetween(const glm::dquat& from, const glm::dquat& to) noexcept;
/// Returns a rotated axis. @param turn rotation vector, rad; its component along the axis has no effect. @return unit
/// length
glm::dvec3 turned(const glm::dvec3& axis, const glm::dvec3& turn) noexcept;

} // namespace burin
