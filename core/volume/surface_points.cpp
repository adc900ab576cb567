// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_points.h"

#include "core/base/vectorised.h"
#include "core/geometry/four_floats.h"
#include "core/volume/surface_crossings.h"

namespace burin {

namespace {

static_assert(SurfaceFrame::spare >= lanes && SurfaceCrossings::spare >= lanes);

/// Numbers along u, v and the runs, of eight cubes.
struct Triple {
    Floats u, v, n;
};

/// One number at each corner of eight cubes: by u, v, n.
struct Corners {
    Integers at[2][2][2];
};

/// Nodes n and n + 1 of one column each, in one word.
BURIN_INLINE Words pairs(const std::int16_t* nodes, const std::uint32_t* cubes) noexcept {
    const auto at = [&](int i) {
        std::uint32_t pair;
        __builtin_memcpy(&pair, nodes + SurfaceCrossings::placeOf(cubes[i]), sizeof pair);
        return pair;
    };
    return Words{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}
BURIN_INLINE Corners cornersOf(const std::int16_t* low, const std::int16_t* high, int stride,
                               const std::uint32_t* cubes) noexcept {
    Corners corners;
    for (int u = 0; u < 2; ++u)
        for (int v = 0; v < 2; ++v) {
            const auto both = reinterpret_cast<Integers>(pairs((v == 0 ? low : high) + u * stride, cubes));
            corners.at[u][v][0] = both << 16 >> 16;
            corners.at[u][v][1] = both >> 16;
        }
    return corners;
}

/// above / below, not divided yet: one division then serves a sum of four.
struct Share {
    Floats above, below;
};
BURIN_INLINE Share operator+(const Share& a, const Share& b) noexcept {
    return {a.above * b.below + b.above * a.below, a.below * b.below};
}

/// Where an edge is crossed, from its one end to the other, 0 where it is not; and whether (all bits or none).
struct Crossing {
    Share place;
    Integers is;
};
BURIN_INLINE Crossing crossing(Integers from, Integers to) noexcept {
    const Integers is = (from ^ to) >> 31;
    return {{floatsOf(from & is), floatsOf(((from - to) & is) - ~is)}, is}; // 0 / 1 where it is not
}

/// The crossings on four parallel edges. A number of crossings is counted downwards, as `is` is -1.
struct FourCrossings {
    Floats places;          ///< sum of places along the edges
    Integers count;         ///< how many
    Integers first, second; ///< and of those how many on edges at the far side of the other two axes, in their order
};
BURIN_INLINE FourCrossings sum(const Crossing (&edges)[2][2]) noexcept {
    const Share places = (edges[0][0].place + edges[0][1].place) + (edges[1][0].place + edges[1][1].place);
    const Integers far = edges[1][0].is + edges[1][1].is;
    return {places.above / places.below, edges[0][0].is + edges[0][1].is + far, far, edges[0][1].is + edges[1][1].is};
}

/// In the middle of the crossings on the cubes' twelve edges, 0 … 1 from the lowest corner.
BURIN_INLINE Triple middleOfCrossings(const Corners& corners) noexcept {
    const auto& at = corners.at;
    Crossing alongU[2][2], alongV[2][2], alongN[2][2];
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            alongU[a][b] = crossing(at[0][a][b], at[1][a][b]);
            alongV[a][b] = crossing(at[a][0][b], at[a][1][b]);
            alongN[a][b] = crossing(at[a][b][0], at[a][b][1]);
        }
    const FourCrossings u = sum(alongU), v = sum(alongV), n = sum(alongN);
    const Floats each = 1.0F / floatsOf(u.count + v.count + n.count);
    return {(floatsOf(v.first + n.first) - u.places) * each, (floatsOf(u.first + n.second) - v.places) * each,
            (floatsOf(u.second + v.second) - n.places) * each};
}

BURIN_INLINE Floats between(Floats a, Floats b, Floats share) noexcept {
    return a + share * (b - a);
}
BURIN_INLINE Floats between(const Floats (&at)[2][2], Floats first, Floats second) noexcept {
    return between(between(at[0][0], at[0][1], second), between(at[1][0], at[1][1], second), first);
}

/// Downhill at a place in the cubes, unit length; where the field is level there, along the runs.
BURIN_INLINE Triple outwards(const Corners& corners, const Triple& place) noexcept {
    const auto& at = corners.at;
    Floats alongU[2][2], alongV[2][2], alongN[2][2];
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            alongU[a][b] = floatsOf(at[0][a][b] - at[1][a][b]);
            alongV[a][b] = floatsOf(at[a][0][b] - at[a][1][b]);
            alongN[a][b] = floatsOf(at[a][b][0] - at[a][b][1]);
        }
    const Floats u = between(alongU, place.v, place.n), v = between(alongV, place.u, place.n),
                 n = between(alongN, place.u, place.v);
    const Floats square = u * u + v * v + n * n;
    const Floats length = rootsOf(square), shorter = 1.0F / length;
    const Integers any = square > 0.0F;
    return {any ? u * shorter : floats(0.0F), any ? v * shorter : floats(0.0F), any ? n * shorter : floats(1.0F)};
}

/// Writes eight vectors; the last one four numbers wide.
BURIN_INLINE void storeVectors(const EightFloats (&axes)[3], glm::vec3* to) noexcept {
    for (int first = 0; first < lanes; first += 4) {
        const FourFloats x = fourAt(axes[0].lane + first), y = fourAt(axes[1].lane + first),
                         z = fourAt(axes[2].lane + first);
        const FourFloats low = __builtin_shufflevector(x, y, 0, 4, 1, 5),
                         high = __builtin_shufflevector(x, y, 2, 6, 3, 7);
        const FourFloats vectors[4]{
            __builtin_shufflevector(low, z, 0, 1, 4, 4), __builtin_shufflevector(low, z, 2, 3, 5, 5),
            __builtin_shufflevector(high, z, 0, 1, 6, 6), __builtin_shufflevector(high, z, 2, 3, 7, 7)};
        for (int i = 0; i < 4; ++i) put(vectors[i], &to[first + i].x);
    }
}

} // namespace

BURIN_VECTORISED_TO_AVX512 void placeSurfacePoints(const SurfaceFrame& frame,
                                                   const std::array<SurfaceField::Row, 2>& rows,
                                                   std::span<const std::uint32_t> cubes, glm::vec3* points,
                                                   glm::vec3* normals) noexcept {
    const SurfaceField::Row low = rows[0], high = rows[1];
    const auto axisU = static_cast<std::size_t>(frame.axes[0]), axisV = static_cast<std::size_t>(frame.axes[1]),
               axisN = static_cast<std::size_t>(frame.axes[2]);
    EightFloats place[3], direction[3];
    for (std::size_t i = 0; i < cubes.size(); i += lanes) {
        const std::uint32_t* const eight = cubes.data() + i;
        const Triple within = middleOfCrossings(cornersOf(low.values, high.values, frame.stride, eight));
        const Triple normal = outwards(cornersOf(low.smooth, high.smooth, frame.stride, eight), within);
        Words cube;
        __builtin_memcpy(&cube, eight, sizeof cube);
        const auto column = reinterpret_cast<Integers>(cube >> 16);
        const Integers node = reinterpret_cast<Integers>(cube & 0xffff) - column * frame.stride;
        store(frame.low[0] + frame.size * (floatsOf(column + frame.firstU) + within.u), place[axisU]);
        store(frame.low[1] + frame.size * (static_cast<float>(frame.v) + within.v), place[axisV]);
        store(frame.low[2] + frame.size * (floatsOf(node + frame.firstNode) + within.n), place[axisN]);
        store(normal.u, direction[axisU]);
        store(normal.v, direction[axisV]);
        store(normal.n, direction[axisN]);
        storeVectors(place, points + i);
        storeVectors(direction, normals + i);
    }
}

} // namespace burin
