// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// Corners of one triangle, mm, counter-clockwise seen from outside.
using Triangle = std::array<glm::dvec3, 3>;

/// The part of a triangle that a point of it belongs to; edge ab runs from corner 0 to corner 1, and so on.
enum class TriangleFeature : std::uint8_t { face, edgeAB, edgeBC, edgeCA, cornerA, cornerB, cornerC };

/// @param edge  0 … 2, starting at the corner of that number
constexpr TriangleFeature edgeFeature(int edge) noexcept {
    return static_cast<TriangleFeature>(1 + edge);
}
/// @param corner 0 … 2
constexpr TriangleFeature cornerFeature(int corner) noexcept {
    return static_cast<TriangleFeature>(4 + corner);
}

struct TrianglePoint {
    glm::dvec3 point{0.0};
    TriangleFeature feature = TriangleFeature::face;
};

/// The point of a triangle that is nearest to `p`. A triangle without area is treated as its longest edge.
TrianglePoint closestOnTriangle(const Triangle& triangle, const glm::dvec3& p) noexcept;

/// Normal by the right-hand rule; its length is twice the area.
inline glm::dvec3 areaNormal(const Triangle& t) noexcept {
    return glm::cross(t[1] - t[0], t[2] - t[0]);
}

} // namespace burin
