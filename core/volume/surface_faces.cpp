// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_faces.h"

#include "core/base/vectorised.h"
#include "core/geometry/four_floats.h"
#include "core/volume/surface_crossings.h"

namespace burin {

namespace {

using FourWords = std::uint32_t __attribute__((vector_size(16)));

/// A point, and one number more that means nothing.
BURIN_INLINE FourFloats four(const glm::vec3* point) noexcept {
    return fourAt(&point->x);
}

/// All bits where the first diagonal is longer than the second.
BURIN_INLINE FourWords longer(FourFloats first, FourFloats second) noexcept {
    const FourFloats a = first * first, b = second * second;
    const FourFloats xy = __builtin_shufflevector(a, b, 0, 4, 1, 5), z = __builtin_shufflevector(a, b, 2, 6, 2, 6);
    const FourFloats squares = xy + __builtin_shufflevector(xy, xy, 2, 3, 2, 3) + z;
    return reinterpret_cast<FourWords>(__builtin_shufflevector(squares, squares, 0, 0, 0, 0) >
                                       __builtin_shufflevector(squares, squares, 1, 1, 1, 1));
}

} // namespace

BURIN_VECTORISED void writeSurfaceFaces(std::span<const std::uint32_t> edges, const QuadrangleCorners& corners,
                                        const glm::vec3* points, std::uint32_t* triangles) noexcept {
    const std::uint32_t* const turned[2]{corners[3], corners[1]}; // the second corner, if the edge's start is inside
    for (const std::uint32_t edge : edges) {
        const std::uint32_t start = SurfaceCrossings::startOf(edge), inside = SurfaceCrossings::startsInside(edge);
        const std::uint32_t a = corners[0][start], b = turned[inside][start], c = corners[2][start],
                            d = turned[1 - inside][start];
        const FourWords turn = longer(four(points + a) - four(points + c), four(points + b) - four(points + d));
        const FourWords corner{a, b, c, d};
        const FourWords next = __builtin_shufflevector(corner, corner, 1, 2, 3, 0);
        const FourWords chosen = corner ^ ((corner ^ next) & turn);
        const FourWords three = __builtin_shufflevector(chosen, chosen, 0, 1, 2, 0);
        const FourWords rest = __builtin_shufflevector(chosen, chosen, 2, 3, 2, 3);
        __builtin_memcpy(triangles, &three, sizeof three);
        __builtin_memcpy(triangles + 4, &rest, 2 * sizeof *triangles);
        triangles += 6;
    }
}

} // namespace burin
