// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace burin {

/// Points all over a mesh: every corner (once, if its triangles follow each other closely), and on triangles larger
/// than a spacing a grid of that spacing.
class SurfacePoints {
public:
    SurfacePoints() { seen_.fill(glm::dvec3(std::nan(""))); }

    /// @param take receives the points of a triangle, and its width (its least height) if it is larger than the
    /// spacing, otherwise 0
    template <class Take>
    void of(const Triangle& triangle, double spacing, const Take& take) {
        for (const glm::dvec3& corner : triangle)
            if (isNew(corner)) take(corner, 0.0);
        std::size_t base = 0; // the longest edge begins here
        for (std::size_t i = 1; i < 3; ++i)
            if (squaredEdge(triangle, i) > squaredEdge(triangle, base)) base = i;
        if (!(squaredEdge(triangle, base) > spacing * spacing)) return;
        const double longest = std::sqrt(squaredEdge(triangle, base));
        const glm::dvec3 &from = triangle[base], &to = triangle[(base + 1) % 3], &top = triangle[(base + 2) % 3];
        const double height = glm::length(areaNormal(triangle)) / longest;
        const int rows = std::max(1, static_cast<int>(std::ceil(height / spacing)));
        for (int row = 0; row < rows; ++row) {
            const double up = static_cast<double>(row) / rows;
            const glm::dvec3 low = glm::mix(from, top, up), high = glm::mix(to, top, up);
            const int columns = std::max(1, static_cast<int>(std::ceil(longest * (1.0 - up) / spacing)));
            for (int column = 0; column <= columns; ++column)
                take(glm::mix(low, high, static_cast<double>(column) / columns), height);
        }
    }

private:
    static double squaredEdge(const Triangle& triangle, std::size_t edge) noexcept {
        const glm::dvec3 way = triangle[(edge + 1) % 3] - triangle[edge];
        return glm::dot(way, way);
    }
    bool isNew(const glm::dvec3& corner) noexcept {
        const auto mixed = std::bit_cast<std::uint64_t>(corner.x) * 3 + std::bit_cast<std::uint64_t>(corner.y) * 5 +
                           std::bit_cast<std::uint64_t>(corner.z) * 7;
        glm::dvec3& seen = seen_[(mixed * 0x9E3779B97F4A7C15ULL) >> 56];
        if (seen == corner) return false;
        seen = corner;
        return true;
    }

    std::array<glm::dvec3, 256> seen_;
};

} // namespace burin
