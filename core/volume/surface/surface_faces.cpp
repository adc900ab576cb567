// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_faces.h"

#include "core/base/vectorised.h"
#include "core/geometry/four_floats.h"
#include "core/volume/surface/surface_edges.h"

#include <algorithm>

namespace burin {

namespace {

using Corners = SurfaceFaces::Corners;
using Difference = SurfaceFaces::Difference;

/// The vector from one point to another, and one more number that is meaningless.
BURIN_INLINE FourFloats way(const glm::vec3* from, const glm::vec3* to) noexcept {
    return fourAt(&to->x) - fourAt(&from->x);
}

BURIN_VECTORISED void lookAllUp(std::span<const std::uint32_t> edges, const QuadrangleCorners& places,
                                const glm::vec3* points, Corners* corners, Difference* differences) noexcept {
    const auto [firsts, seconds, thirds, fourths] = places;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t start = SurfaceEdges::startOf(edges[i]), turn = 2 * SurfaceEdges::startsInside(edges[i]);
        const std::size_t a = firsts[start], b = seconds[start], c = thirds[start], d = fourths[start];
        std::uint32_t* const at = corners[i].at;
        at[0] = static_cast<std::uint32_t>(a);
        at[3 - turn] = static_cast<std::uint32_t>(b);
        at[2] = static_cast<std::uint32_t>(c);
        at[1 + turn] = static_cast<std::uint32_t>(d);
        const FourFloats first = way(points + a, points + c), other = way(points + b, points + d);
        put(other * other - first * first, differences[i].of);
    }
}

/// Sums of the first three components of each of four vectors.
BURIN_INLINE FourFloats sums(const Difference* four) noexcept {
    const FourFloats a = fourAt(four[0].of), b = fourAt(four[1].of), c = fourAt(four[2].of), d = fourAt(four[3].of);
    const FourFloats xyAb = __builtin_shufflevector(a, b, 0, 4, 1, 5), zAb = __builtin_shufflevector(a, b, 2, 6, 2, 6),
                     xyCd = __builtin_shufflevector(c, d, 0, 4, 1, 5), zCd = __builtin_shufflevector(c, d, 2, 6, 2, 6);
    return __builtin_shufflevector(xyAb, xyCd, 0, 1, 4, 5) + __builtin_shufflevector(xyAb, xyCd, 2, 3, 6, 7) +
           __builtin_shufflevector(zAb, zCd, 0, 1, 4, 5);
}

/// Writes two triangles for each of two quadrilaterals.
/// @param turn  all bits in the four lanes of a quadrilateral that is split between its second and its fourth corner
BURIN_INLINE void writeTriangles(const Corners* two, Integers turn, std::uint32_t* triangles) noexcept {
    Integers corner;
    static_assert(sizeof corner == 2 * sizeof *two);
    __builtin_memcpy(&corner, two, sizeof corner);
    const Integers next = __builtin_shufflevector(corner, corner, 1, 2, 3, 0, 5, 6, 7, 4);
    const Integers chosen = corner ^ ((corner ^ next) & turn);
    const Integers most = __builtin_shufflevector(chosen, chosen, 0, 1, 2, 0, 2, 3, 4, 5);
    const auto rest = __builtin_shufflevector(chosen, chosen, 6, 4, 6, 7);
    __builtin_memcpy(triangles, &most, sizeof most);
    __builtin_memcpy(triangles + lanes, &rest, sizeof rest);
}

constexpr std::size_t together = 4;
static_assert(SurfaceFaces::spareCorners >= 6 * (together - 1));

/// Also writes the quadrilaterals behind the last one, whatever they contain.
BURIN_VECTORISED void writeAll(const Corners* corners, const Difference* differences, std::size_t count,
                               std::uint32_t* triangles) noexcept {
    for (std::size_t i = 0; i < count; i += together, triangles += 6 * together) {
        const FourInts turns = sums(differences + i) < 0.0F;
        writeTriangles(corners + i, __builtin_shufflevector(turns, turns, 0, 0, 0, 0, 1, 1, 1, 1), triangles);
        writeTriangles(corners + i + 2, __builtin_shufflevector(turns, turns, 2, 2, 2, 2, 3, 3, 3, 3), triangles + 12);
    }
}

} // namespace

std::span<const std::uint32_t> SurfaceFaces::lookUp(std::span<const std::uint32_t> edges,
                                                    const QuadrangleCorners& corners,
                                                    const glm::vec3* points) noexcept {
    const auto some = edges.first(std::min(edges.size(), most - count_));
    lookAllUp(some, corners, points, corners_.data() + count_, differences_.data() + count_);
    count_ += some.size();
    return edges.subspan(some.size());
}

void SurfaceFaces::write(std::uint32_t* triangles) noexcept {
    writeAll(corners_.data(), differences_.data(), count_, triangles);
    count_ = 0;
}

} // namespace burin
