// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Whether the low side along an axis must be kept so that the eye looks at the cut face of a section plane.
/// @param along direction of the sight line through the centre of the picture, unit
inline bool keepsLowBefore(const glm::dvec3& along, int axis) noexcept {
    constexpr double straight = 0.05; // component of a direction: the eye is on neither side
    return axis == 1 ? along.y < -straight : along[axis] < straight;
}

} // namespace burin
