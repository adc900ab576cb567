// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/gap_window_kernels.h"

#include <bit>

namespace burin::kernels {

namespace {

BURIN_INLINE GapWindow::Gap& gapOf(const GapWindow::Row& row, std::int32_t group) noexcept {
    return row.gaps[static_cast<std::uint32_t>(row.firstGroup + group) & row.mask];
}

/// Adds what one side of eight gaps lost. `middle`: of it, doubled, run units.
BURIN_INLINE void addSide(Integers taken, Words neighbour, Integers middle, Floats u,
                          GapWindow::RowSums& sums) noexcept {
    std::uint32_t left = bitsOf(taken != Integers{});
    if (left == 0) return;
    const auto property = reinterpret_cast<Integers>(neighbour & 255U);
    while (left != 0) {
        const std::int32_t one = property[std::countr_zero(left)];
        const Integers same = property == one;
        const auto place = static_cast<std::size_t>(one);
        store(load(sums.byProperty[place]) + (taken & same), sums.byProperty[place]);
        sums.used[place / 64] |= std::uint64_t{1} << (place % 64);
        left &= ~bitsOf(same);
    }
    const Floats units = floatsOf(taken);
    store(load(sums.units) + units, sums.units);
    store(load(sums.momentU) + units * u, sums.momentU);
    store(load(sums.momentAlong) + units * floatsOf(middle - sums.alongOrigin), sums.momentAlong);
}

} // namespace

BURIN_VECTORISED std::int32_t findHits(const GapWindow::Row& row, std::int32_t* hits) noexcept {
    std::int32_t count = 0;
    for (std::int32_t group = 0; group < row.groups; ++group) {
        const GapWindow::Gap& gap = gapOf(row, group);
        const Integers low = load(row.low[group]), high = load(row.high[group]);
        const Integers hit = ((low < load(gap.low)) | (high > load(gap.high))) & (low < high);
        hits[count] = group;
        count += bitsOf(hit) != 0 ? 1 : 0;
    }
    return count;
}

BURIN_VECTORISED void growGaps(const GapWindow::Row& row, const std::int32_t* hits, std::int32_t hitCount,
                               GapWindow::RowSums& sums, Growth& growth) noexcept {
    std::int32_t open = 0;
    for (std::int32_t i = 0; i < hitCount; ++i) {
        const std::int32_t group = hits[i];
        GapWindow::Gap& gap = gapOf(row, group);
        const Integers low = load(row.low[group]), high = load(row.high[group]);
        const Integers oldLow = load(gap.low), oldHigh = load(gap.high);
        const Words left = load(gap.left), right = load(gap.right);
        const Integers hit = ((low < oldLow) | (high > oldHigh)) & (low < high);
        const Integers within = (high <= most(oldHigh, reinterpret_cast<Integers>(right >> 8))) &
                                (low >= least(oldLow, reinterpret_cast<Integers>(left >> 8))) & (low <= oldHigh) &
                                (high >= oldLow);
        const Integers grows = hit & within;
        const Integers newLow = grows ? least(low, oldLow) : oldLow;
        const Integers newHigh = grows ? most(high, oldHigh) : oldHigh;
        const Floats u = floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + group * lanes);
        addSide(oldLow - newLow, left, oldLow + newLow, u, sums);
        addSide(newHigh - oldHigh, right, oldHigh + newHigh, u, sums);
        store(newLow, gap.low);
        store(newHigh, gap.high);
        growth.cutLanes[i] = bitsOf(grows);
        growth.open[open] = i;
        growth.openLanes[open] = bitsOf(hit & ~within);
        open += growth.openLanes[open] != 0 ? 1 : 0;
    }
    growth.openCount = open;
}

} // namespace burin::kernels
