// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <glm/glm.hpp>

namespace burin {

/// A rigid placement in another frame: rotation or reflection first, then translation. Lengths are preserved.
struct Placement {
    glm::dmat3 turn{1.0};  ///< orthogonal; of determinant 1, or -1 where it mirrors
    glm::dvec3 shift{0.0}; ///< mm, in the other frame

    glm::dvec3 point(const glm::dvec3& place) const noexcept { return turn * place + shift; }
    glm::dvec3 direction(const glm::dvec3& way) const noexcept { return turn * way; }
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// Whether it is the identity.
bool isNone(const Placement& placement) noexcept;
bool mirrors(const Placement& placement) noexcept;
/// Whether it is finite and preserves lengths, to 1e-9.
bool isSound(const Placement& placement) noexcept;
/// Whether it maps the axes of a frame to axes: one quarter turn, or several.
bool alongAxes(const Placement& placement) noexcept;

/// First `first`, then `second`.
Placement combined(const Placement& first, const Placement& second) noexcept;
Placement inverse(const Placement& placement) noexcept;

/// Rotation about an axis through a point. Quarter turns about the frame's axes are exact, without rounding errors.
/// @param axis  of any length but 0  @param angle  rad, by the right-hand rule  @param through  mm
Placement turnedAbout(const glm::dvec3& axis, double angle, const glm::dvec3& through) noexcept;
/// The shortest rotation that takes one direction to another; for opposite ones half a turn about x, or about y if they
/// are parallel to x.
/// @param from, to  of any length but 0  @param through  mm
Placement turnedTowards(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& through) noexcept;
/// @param by  mm
Placement movedBy(const glm::dvec3& by) noexcept;
/// Reflection in the plane perpendicular to an axis of the frame. @param axis  0, 1, 2 for x, y, z  @param through  mm
Placement mirroredAcross(int axis, const glm::dvec3& through) noexcept;

/// The bounding box of a placed box; for a placement along axes the placed box itself.
Box boxAround(const Box& box, const Placement& placement) noexcept;

} // namespace burin
