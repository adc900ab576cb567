// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"

#include <rapidcheck.h>

namespace burin::test {

inline constexpr double surfaceVoxel = 0.25; ///< mm

/// Runs along any axis.
inline Grid randomlyTurnedGrid(glm::ivec3 count) {
    return *Grid::make({-3.0, 5.0, 1.0}, surfaceVoxel, count, static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
}

/// Stock with slots next to bosses, splinters, and balls of any material or air.
inline void fillAtRandom(RunVolume& volume) {
    const Grid& grid = volume.grid();
    RC_ASSERT(volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, *rc::gen::inRange<RunPosition>(0, 9000),
                               grid.lineEnd(), wax));
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        const LineIndex low{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
        const std::int32_t middle = low.u + *rc::gen::inRange(1, 8), highU = middle + *rc::gen::inRange(1, 20),
                           highV = low.v + *rc::gen::inRange(1, 20);
        const auto begin = *rc::gen::inRange<RunPosition>(0, grid.lineEnd()),
                   end = *rc::gen::element(grid.lineEnd(), begin + *rc::gen::inRange<RunPosition>(1, 2000));
        const auto fill = [&](std::int32_t from, std::int32_t to) {
            return volume.fillBlock({from, low.v}, {to, highV}, begin, end, *rc::gen::inRange<PropertyIndex>(0, 4));
        };
        RC_ASSERT(fill(low.u, middle) && fill(middle, highU));
    }
    RunAmounts removed;
    for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
        const LineIndex line{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
        const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
        (void)volume.removeSpan(line, from, from + *rc::gen::inRange<RunPosition>(0, 20000), removed);
    }
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        const glm::dvec3 share(*rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100));
        fillSphere(volume, *rc::gen::inRange<PropertyIndex>(0, 4), grid.box().low + share / 100.0 * grid.box().size(),
                   surfaceVoxel * *rc::gen::inRange(1, 30));
    }
}

template <class Visit>
void eachBrick(const Grid& grid, Visit visit) {
    const glm::ivec2 tiles = surfaceTiles(grid);
    for (int v = 0; v < tiles.y; ++v)
        for (int u = 0; u < tiles.x; ++u)
            for (int n = 0; n * linesPerSurfaceTile < grid.voxelsPerLine(); ++n) visit(SurfaceBrick{u, v, n});
}

} // namespace burin::test
