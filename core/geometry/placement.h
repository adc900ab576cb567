// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <glm/glm.hpp>

namespace burin {

/// How something lies in another frame: turned or mirrored first, then moved. Lengths are kept.
struct Placement {
    glm::dmat3 turn{1.0};  ///< orthogonal; of determinant 1, or -1 where it mirrors
    glm::dvec3 shift{0.0}; ///< mm, in the other frame

    glm::dvec3 point(const glm::dvec3& place) const noexcept { return turn * place + shift; }
    glm::dvec3 direction(const glm::dvec3& way) const noexcept { return turn * way; }
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// Neither turned nor moved.
bool isNone(const Placement& placement) noexcept;
bool mirrors(const Placement& placement) noexcept;
/// Whether it keeps lengths, as it says of itself, and is finite: to 1e-9.
bool isSound(const Placement& placement) noexcept;
/// Whether it takes the axes of a frame to axes: a quarter turn, or several.
bool alongAxes(const Placement& placement) noexcept;

/// First `first`, then `second`.
Placement combined(const Placement& first, const Placement& second) noexcept;
Placement inverse(const Placement& placement) noexcept;

/// About an axis through a place. Quarter turns about the frame's axes are exact: no part of a millionth comes in.
/// @param axis of any length but 0 @param angle rad, by the right hand @param through mm
Placement turnedAbout(const glm::dvec3& axis, double angle, const glm::dvec3& through) noexcept;
/// By the shortest turn that takes one direction to another; opposite ones: half a turn about x, or about y where they
/// lie along x.
/// @param from, to of any length but 0 @param through mm
Placement turnedTowards(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& through) noexcept;
/// @param by mm
Placement movedBy(const glm::dvec3& by) noexcept;
/// In the plane square to an axis of the frame. @param axis 0, 1, 2 for x, y, z @param through mm
Placement mirroredAcross(int axis, const glm::dvec3& through) noexcept;

/// The smallest box around a placed one; of a placement along axes the placed box itself.
Box boxAround(const Box& box, const Placement& placement) noexcept;

} // namespace burin
