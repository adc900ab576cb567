// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_tree.h"

#include <optional>

namespace burin {

/// A half-line, mm.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0}; ///< of any length but zero
};

/// Where a ray meets a surface.
struct TriangleHit {
    double distance = 0.0; ///< in multiples of the length of the ray's direction, >= 0
    bool leaving = false;  ///< from the triangle's inner side to its outer side
};

/// Intersection of a ray with a triangle, from either side. Empty if it misses or runs in the triangle's plane.
/// Source: T. Möller and B. Trumbore, Fast, minimum storage ray/triangle intersection, Journal of Graphics Tools 2
/// (1997).
std::optional<TriangleHit> hitOf(const Ray& ray, const Triangle& triangle) noexcept;

/// The nearest intersection with a triangle. Empty if the ray misses all of them. No allocation. Cost: some
/// microseconds.
std::optional<TriangleHit> nearestHit(const Ray& ray, const TriangleTree& tree) noexcept;

} // namespace burin
