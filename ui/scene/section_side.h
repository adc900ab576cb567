// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Whether the low half along an axis is the one to keep, so that the eye looks into what a section plane cuts open.
/// @param along the direction of the sight through the middle of the picture, unit
inline bool keepsLowBefore(const glm::dvec3& along, int axis) noexcept {
    constexpr double straight = 0.05; // of a direction: the eye is on neither side
    return axis == 1 ? along.y < -straight : along[axis] < straight;
}

} // namespace burin
