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

/// Unit normal; zero for a triangle without area.
inline glm::dvec3 unitNormal(const Triangle& triangle) noexcept {
    const glm::dvec3 normal = areaNormal(triangle);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// The largest of the triangles that were added; all corners are the origin if there is none.
class LargestTriangle {
public:
    void add(const Triangle& triangle) noexcept {
        const double size = glm::length(areaNormal(triangle));
        if (size <= size_) return;
        size_ = size;
        corners_ = triangle;
    }
    const Triangle& corners() const noexcept { return corners_; }
    glm::dvec3 centroid() const noexcept { return (corners_[0] + corners_[1] + corners_[2]) / 3.0; }

private:
    Triangle corners_{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
    double size_ = -1.0; ///< twice the area, mm²
};

} // namespace burin
