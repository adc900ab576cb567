// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0

// Part of surface_points.cpp, which includes it once for each width of registers (core/base/whole_registers.h).

static_assert(SurfaceBatch::most % width == 0 && SurfaceBatch::spare >= width && SurfaceFrame::spare >= width);

/// One number at each corner of the cubes: by u, v, n.
struct Corners {
    Floats at[2][2][2];
};
struct Signs {
    Mask at[2][2][2]; ///< where the number is below 0
};

constexpr int cornerWords = sizeof(SurfaceBatch::Corners) / sizeof(std::uint32_t); ///< from cube to cube
/// The values of the nodes times 2^16, so that each half of a word is used without shifting it down: only ratios and
/// directions are derived from them.
/// @param first  of the values at the corners of cubes
BURIN_INLINE Corners cornersOf(const std::uint32_t (&first)[4]) noexcept {
    const auto pairs = foursAt<Words, cornerWords>(first);
    Corners corners;
    for (int u = 0; u < 2; ++u)
        for (int v = 0; v < 2; ++v) {
            const Words both = pairs.of[u + 2 * v];
            corners.at[u][v][0] = floatsOf(reinterpret_cast<Integers>(both << 16));
            corners.at[u][v][1] = floatsOf(reinterpret_cast<Integers>(both & 0xffff0000U));
        }
    return corners;
}
BURIN_INLINE Signs signsOf(const Corners& corners) noexcept {
    Signs signs;
    for (int u = 0; u < 2; ++u)
        for (int v = 0; v < 2; ++v)
            for (int n = 0; n < 2; ++n) signs.at[u][v][n] = hasSign(corners.at[u][v][n]);
    return signs;
}

/// The fraction above / below, not divided yet: one division then suffices for a sum of four.
struct Share {
    Floats above, below;
};
BURIN_INLINE Share operator+(const Share& a, const Share& b) noexcept {
    return {a.above * b.below + b.above * a.below, a.below * b.below};
}
/// Position of the crossing on an edge, from one end to the other; 0 if it is not crossed.
BURIN_INLINE Share crossing(Floats from, Floats to, Mask is) noexcept {
    return {select(is, from, Floats{}), select(is, from - to, each(1.0F))};
}

/// The crossings on four parallel edges.
struct FourCrossings {
    Floats places;          ///< sum of the positions along the edges
    Integers count;         ///< how many
    Integers first, second; ///< and how many of them on edges at the far side of the first, the second other axis
    Mask lowest;            ///< whether the edge at the low sides is crossed
};
/// @param from, to  by the edges' positions along the other two axes in their order; and whether they are below 0
BURIN_INLINE FourCrossings crossingsOn(const Floats (&from)[2][2], const Floats (&to)[2][2],
                                       const Mask (&fromBelow)[2][2], const Mask (&toBelow)[2][2]) noexcept {
    const Mask is[2][2]{{fromBelow[0][0] ^ toBelow[0][0], fromBelow[0][1] ^ toBelow[0][1]},
                        {fromBelow[1][0] ^ toBelow[1][0], fromBelow[1][1] ^ toBelow[1][1]}};
    const Share places = (crossing(from[0][0], to[0][0], is[0][0]) + crossing(from[0][1], to[0][1], is[0][1])) +
                         (crossing(from[1][0], to[1][0], is[1][0]) + crossing(from[1][1], to[1][1], is[1][1]));
    const Integers first = counted(counted(Integers{}, is[1][0]), is[1][1]);
    return {places.above / places.below, counted(counted(first, is[0][0]), is[0][1]), first,
            counted(counted(Integers{}, is[0][1]), is[1][1]), is[0][0]};
}

/// Numbers along u, v and the runs.
struct Triple {
    Floats u, v, n;
};

/// The crossings on a cube's twelve edges.
struct Crossings {
    FourCrossings u, v, n;
};
BURIN_INLINE Crossings crossingsOf(const Corners& corners, const Signs& signs) noexcept {
    const auto& at = corners.at;
    const auto& below = signs.at;
    // Along v: by u, n; along the runs: by u, v.
    const Floats fromV[2][2]{{at[0][0][0], at[0][0][1]}, {at[1][0][0], at[1][0][1]}},
        toV[2][2]{{at[0][1][0], at[0][1][1]}, {at[1][1][0], at[1][1][1]}},
        fromN[2][2]{{at[0][0][0], at[0][1][0]}, {at[1][0][0], at[1][1][0]}},
        toN[2][2]{{at[0][0][1], at[0][1][1]}, {at[1][0][1], at[1][1][1]}};
    const Mask belowFromV[2][2]{{below[0][0][0], below[0][0][1]}, {below[1][0][0], below[1][0][1]}},
        belowToV[2][2]{{below[0][1][0], below[0][1][1]}, {below[1][1][0], below[1][1][1]}},
        belowFromN[2][2]{{below[0][0][0], below[0][1][0]}, {below[1][0][0], below[1][1][0]}},
        belowToN[2][2]{{below[0][0][1], below[0][1][1]}, {below[1][0][1], below[1][1][1]}};
    return {crossingsOn(at[0], at[1], below[0], below[1]), crossingsOn(fromV, toV, belowFromV, belowToV),
            crossingsOn(fromN, toN, belowFromN, belowToN)};
}

/// The mean of the crossings, 0 … 1 from the lowest corner.
BURIN_INLINE Triple middleOf(const Crossings& crossings) noexcept {
    const auto& [u, v, n] = crossings;
    const Floats whole = 1.0F / floatsOf(u.count + v.count + n.count);
    return {(floatsOf(v.first + n.first) + u.places) * whole, (floatsOf(u.first + n.second) + v.places) * whole,
            (floatsOf(u.second + v.second) + n.places) * whole};
}

BURIN_INLINE Floats between(Floats a, Floats b, Floats share) noexcept {
    return a + share * (b - a);
}

/// Downhill direction at a position in the cubes.
BURIN_INLINE Triple downhill(const Corners& corners, const Triple& place) noexcept {
    const auto& at = corners.at;
    Floats falls[2][2], here[2][2]; // by v, n: fall along u from end to end, and the value at the position
    for (int v = 0; v < 2; ++v)
        for (int n = 0; n < 2; ++n) {
            falls[v][n] = at[0][v][n] - at[1][v][n];
            here[v][n] = at[0][v][n] - place.u * falls[v][n];
        }
    return {between(between(falls[0][0], falls[0][1], place.n), between(falls[1][0], falls[1][1], place.n), place.v),
            between(here[0][0] - here[1][0], here[0][1] - here[1][1], place.n),
            between(here[0][0] - here[0][1], here[1][0] - here[1][1], place.v)};
}
/// Scales to unit length; a zero vector becomes the direction of the runs.
BURIN_INLINE Triple unit(const Triple& way) noexcept {
    const Floats square = way.u * way.u + way.v * way.v + way.n * way.n;
    const Floats shorter = 1.0F / rootsOf(square);
    const Mask any = greater(square, Floats{});
    return {select(any, way.u * shorter, Floats{}), select(any, way.v * shorter, Floats{}),
            select(any, way.n * shorter, each(1.0F))};
}

/// @tparam axis  of the runs: 0, 1, 2; that of u is the next one, and that of v the one before
template <int axis>
BURIN_INLINE void store(const Triple& triple, glm::vec3* to) noexcept {
    const Floats alongRunsUv[3]{triple.n, triple.u, triple.v};
    storeVectors(alongRunsUv[(3 - axis) % 3], alongRunsUv[(4 - axis) % 3], alongRunsUv[(5 - axis) % 3], &to->x);
}

/// Numbers along u, v and the runs in memory.
using Triples = SurfaceBatch::Each<float>[3];
BURIN_INLINE void keep(const Triple& triple, Triples& to, std::size_t at) noexcept {
    __builtin_memcpy(&to[0][at], &triple.u, sizeof triple.u);
    __builtin_memcpy(&to[1][at], &triple.v, sizeof triple.v);
    __builtin_memcpy(&to[2][at], &triple.n, sizeof triple.n);
}
BURIN_INLINE Triple kept(const Triples& from, std::size_t at) noexcept {
    return {lanesAt<Floats>(&from[0][at]), lanesAt<Floats>(&from[1][at]), lanesAt<Floats>(&from[2][at])};
}

/// Columns, rows and nodes of cubes, and their indices among those of the rows that are kept.
struct Places {
    Integers column, row, node, place;
};
BURIN_INLINE Places placesOf(const SurfaceFrame& frame, const SurfaceBatch& cubes, std::size_t from) noexcept {
    const auto cube = lanesAt<Words>(&cubes.cubes()[from]);
    const auto column = reinterpret_cast<Integers>(cube >> SurfaceBatch::columnShift & SurfaceBatch::columnMask),
               row = reinterpret_cast<Integers>(cube >> SurfaceBatch::rowShift),
               place = reinterpret_cast<Integers>(cube & SurfaceBatch::placeMask);
    return {column, row, place - column * frame.stride,
            place + (row & (SurfaceFrame::rowsKept - 1)) * frame.placesPerRow};
}

// All cubes of a batch go through each of the steps below before the next step begins, so that the latency of a step
// for one cube is hidden by the work for others.

/// First step: the positions of the points, 0 … 1 from their cubes' lowest corners, and the edges that the cubes own.
BURIN_INLINE void placeWithin(const SurfaceFrame& frame, const SurfaceBatch& cubes, Triples& within,
                              SurfaceEdges& listed) noexcept {
    const Integers column = each(frame.firstEdgeColumn - 1), row = each(frame.firstEdgeRow - 1),
                   node = each(frame.firstEdgeNode - 1);
    std::uint32_t *endU = listed.room(0), *endV = listed.room(1), *endN = listed.room(2);
    const std::size_t count = cubes.count();
    for (std::size_t i = 0; i < count; i += width) {
        const Corners corners = cornersOf(cubes.corners()[i].values);
        const Crossings crossings = crossingsOf(corners, signsOf(corners));
        keep(middleOf(crossings), within, i);
        const Places place = placesOf(frame, cubes, i);
        const Mask owned = greater(each(static_cast<std::int32_t>(count - i)), numbers()) &
                           greater(place.column, column) & greater(place.row, row) & greater(place.node, node);
        const Words start = reinterpret_cast<Words>(place.place) |
                            (~reinterpret_cast<Words>(corners.at[0][0][0]) & SurfaceEdges::insideBit);
        endU = append(start, crossings.u.lowest & owned, endU);
        endV = append(start, crossings.v.lowest & owned, endV);
        endN = append(start, crossings.n.lowest & owned, endN);
    }
    listed.keep({endU, endV, endN});
}

/// Second step: the downhill direction there.
BURIN_INLINE void findWays(const SurfaceBatch& cubes, const Triples& within, Triples& ways) noexcept {
    for (std::size_t i = 0; i < cubes.count(); i += width)
        keep(downhill(cornersOf(cubes.corners()[i].smooth), kept(within, i)), ways, i);
}

/// Last step: stores points and unit directions as vectors.
template <int axis>
BURIN_INLINE void storeAlong(const SurfaceFrame& frame, const SurfaceBatch& cubes, const Triples& within,
                             const Triples& ways, glm::vec3* points, glm::vec3* normals) noexcept {
    for (std::size_t i = 0; i < cubes.count(); i += width) {
        const Places place = placesOf(frame, cubes, i);
        const Triple part = kept(within, i);
        store<axis>({frame.low[0] + frame.size * (floatsOf(place.column + frame.firstU) + part.u),
                     frame.low[1] + frame.size * (floatsOf(place.row + frame.firstV) + part.v),
                     frame.low[2] + frame.size * (floatsOf(place.node + frame.firstNode) + part.n)},
                    points + i);
        store<axis>(unit(kept(ways, i)), normals + i);
    }
}
BURIN_INLINE void storeAll(const SurfaceFrame& frame, const SurfaceBatch& cubes, const Triples& within,
                           const Triples& ways, glm::vec3* points, glm::vec3* normals) noexcept {
    switch (frame.axisOfRuns) {
    case 0:
        return storeAlong<0>(frame, cubes, within, ways, points, normals);
    case 1:
        return storeAlong<1>(frame, cubes, within, ways, points, normals);
    default:
        return storeAlong<2>(frame, cubes, within, ways, points, normals);
    }
}

/// See placeSurfacePoints.
BURIN_INLINE void placeAll(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                           SurfaceEdges& edges) noexcept {
    Triples within, ways;
    placeWithin(frame, cubes, within, edges);
    findWays(cubes, within, ways);
    storeAll(frame, cubes, within, ways, points, normals);
}
