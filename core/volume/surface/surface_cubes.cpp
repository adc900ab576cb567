// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_cubes.h"

#include "core/base/vectorised.h"

#include <bit>

namespace burin {

namespace {

using Bits = std::array<std::uint64_t, SurfaceWindow::mostColumns + 2>;

/// Finds cubes of which some nodes are below 0 and some are not.
BURIN_VECTORISED void findCubes(const std::uint64_t* low, const std::uint64_t* high, int first, int end,
                                std::uint64_t owned, std::uint64_t* cubes) noexcept {
    for (int u = first; u < end; ++u) {
        const std::uint64_t all = low[u] & high[u] & low[u + 1] & high[u + 1];
        const std::uint64_t any = low[u] | high[u] | low[u + 1] | high[u + 1];
        cubes[u] = (any | any >> 1) & ~(all & all >> 1) & owned; // a cube's upper nodes are the next bits
    }
}

/// Lists the cubes of one column. Usually there are one or two: those are handled without a branch.
/// @param lowest  the cube at the column's lowest node
BURIN_INLINE std::uint32_t* list(std::uint64_t bits, std::uint32_t lowest, std::uint32_t* end) noexcept {
    constexpr std::uint64_t guard = std::uint64_t{1} << 63; // no node has this bit
    for (int i = 0; i < 2; ++i) {
        *end = lowest + static_cast<std::uint32_t>(std::countr_zero(bits | guard));
        end += bits != 0 ? 1 : 0;
        bits &= bits - 1;
    }
    for (; bits != 0; bits &= bits - 1) *end++ = lowest + static_cast<std::uint32_t>(std::countr_zero(bits));
    return end;
}

} // namespace

void SurfaceCubes::find(const std::array<SurfaceField::Row, 2>& rows, int stride, const Owned& owned) {
    Bits cubes;
    findCubes(rows[0].below, rows[1].below, owned.firstColumn, owned.endColumn, owned.nodes, cubes.data());
    const std::uint32_t step = cube(1, static_cast<std::uint32_t>(stride)); // from column to column
    std::uint32_t* end = cubes_.data();
    std::uint32_t lowest = static_cast<std::uint32_t>(owned.firstColumn) * step;
    for (int column = owned.firstColumn; column < owned.endColumn; ++column, lowest += step)
        end = list(cubes[static_cast<std::size_t>(column)], lowest, end);
    count_ = static_cast<std::size_t>(end - cubes_.data());
}

} // namespace burin
