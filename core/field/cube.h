// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <numbers>

namespace burin {

/// Largest distance of a point in a cube of edge 1 from its middle, and from the nearest of its corners.
inline constexpr double halfDiagonal = 0.5 * std::numbers::sqrt3;
/// The same as an upper bound in single precision: the next float above.
inline constexpr float halfDiagonalAbove = 0.8660255F;
static_assert(static_cast<double>(halfDiagonalAbove) > halfDiagonal);

/// Corner i of a cube: 0 or 1 along each axis, x running fastest.
inline glm::ivec3 cornerOf(int i) noexcept {
    return {i & 1, (i >> 1) & 1, (i >> 2) & 1};
}

} // namespace burin
