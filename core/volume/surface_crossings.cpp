// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_crossings.h"

#include "core/base/vectorised.h"

#include <algorithm>
#include <bit>

namespace burin {

namespace {

using Bits = std::array<std::uint64_t, SurfaceWindow::mostColumns + 2>;

/// Cubes of which some nodes are inside and some are not.
BURIN_VECTORISED void findCubes(const std::uint64_t* low, const std::uint64_t* high, int first, int end,
                                std::uint64_t owned, std::uint64_t* cubes) noexcept {
    for (int u = first; u < end; ++u) {
        const std::uint64_t all = low[u] & high[u] & low[u + 1] & high[u + 1];
        const std::uint64_t any = low[u] | high[u] | low[u + 1] | high[u + 1];
        cubes[u] = (any | any >> 1) & ~(all & all >> 1) & owned; // a cube's upper nodes are the next bits
    }
}

/// Edges of which one end is inside.
BURIN_VECTORISED void findEdges(const std::uint64_t* low, const std::uint64_t* high, int first, int end,
                                std::uint64_t owned, std::uint64_t* alongU, std::uint64_t* alongV,
                                std::uint64_t* alongRuns) noexcept {
    for (int u = first; u < end; ++u) {
        alongU[u] = (low[u] ^ low[u + 1]) & owned;
        alongV[u] = (low[u] ^ high[u]) & owned;
        alongRuns[u] = (low[u] ^ low[u] >> 1) & owned;
    }
}

/// That a column has one or two cubes is the rule: those go without a branch.
BURIN_INLINE std::uint32_t* list(std::uint64_t bits, std::uint32_t column, std::uint32_t* end) noexcept {
    constexpr std::uint64_t guard = std::uint64_t{1} << 63; // no node is so high
    for (int i = 0; i < 2; ++i) {
        *end = column + static_cast<std::uint32_t>(std::countr_zero(bits | guard));
        end += bits != 0 ? 1 : 0;
        bits &= bits - 1;
    }
    for (; bits != 0; bits &= bits - 1) *end++ = column + static_cast<std::uint32_t>(std::countr_zero(bits));
    return end;
}

} // namespace

void SurfaceCrossings::find(const std::array<SurfaceField::Row, 2>& rows, int stride, const Owned& owned, bool edges) {
    const std::uint64_t *low = rows[0].inside, *high = rows[1].inside;
    Bits cubes;
    findCubes(low, high, owned.firstColumn, owned.endColumn, owned.cubes, cubes.data());
    std::uint32_t* end = cubes_.data();
    for (int u = owned.firstColumn; u < owned.endColumn; ++u) {
        const auto column = static_cast<std::uint32_t>(u), step = static_cast<std::uint32_t>(stride);
        end = list(cubes[column], column << 16 | column * step, end);
    }
    cubeCount_ = static_cast<std::size_t>(end - cubes_.data());
    edgeCount_ = {};
    if (cubeCount_ == 0) return;
    std::fill_n(end, spare, cubes_[0]);
    if (!edges) return;

    // An edge starts at the lowest node of a cube that is crossed as well.
    std::array<Bits, 3> crossed;
    for (Bits& bits : crossed) std::fill_n(bits.begin(), owned.firstEdgeColumn, std::uint64_t{0});
    findEdges(low, high, owned.firstEdgeColumn, owned.endColumn, owned.nodes, crossed[0].data(), crossed[1].data(),
              crossed[2].data());
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < cubeCount_; ++i) {
        const std::uint32_t column = columnOf(cubes_[i]), place = placeOf(cubes_[i]);
        const std::uint32_t node = place - column * static_cast<std::uint32_t>(stride);
        const std::uint32_t edge = place | static_cast<std::uint32_t>(low[column] >> node) << 31;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            edges_[axis][count[axis]] = edge;
            count[axis] += crossed[axis][column] >> node & 1;
        }
    }
    edgeCount_ = count;
}

} // namespace burin
