// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/gap_window_kernels.h"

#include <bit>

namespace burin::kernels {

namespace {

BURIN_INLINE GapWindow::Gap& gapOf(const GapWindow::Row& row, std::int32_t group) noexcept {
    return row.gaps[static_cast<std::uint32_t>(row.firstGroup + group) & row.mask];
}

/// Sums over some gaps, lane by lane.
struct Lanes {
    Floats units, momentU, momentV, momentAlong;
};

/// Adds what one side of eight gaps lost. `middle`: of it, doubled, run units.
BURIN_INLINE void addSide(Integers taken, std::uint32_t which, Words neighbour, Integers middle, Floats u, float v,
                          GapWindow::Sums& sums, Lanes& all) noexcept {
    const auto property = reinterpret_cast<Integers>(neighbour & 255U);
    do {
        const std::int32_t one = property[std::countr_zero(which)];
        const Integers same = property == one;
        const auto place = static_cast<std::size_t>(one);
        store(load(sums.byProperty[place]) + (taken & same), sums.byProperty[place]);
        sums.used[place / 64] |= std::uint64_t{1} << (place % 64);
        which &= ~bitsOf(same);
    } while (which != 0);
    const Floats units = floatsOf(taken);
    all.units += units;
    all.momentU += units * u;
    all.momentV += units * v;
    all.momentAlong += units * floatsOf(middle - sums.alongOrigin);
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
                               GapWindow::Sums& sums, Growth& growth) noexcept {
    std::int32_t open = 0;
    Lanes all{load(sums.units), load(sums.momentU), load(sums.momentV), load(sums.momentAlong)};
    const auto v = static_cast<float>(row.v - sums.originV);
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
        const Integers downs = grows & (low < oldLow), ups = grows & (high > oldHigh);
        const Floats u = floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + ((row.firstGroup + group) * lanes - sums.originU));
        const std::uint32_t down = bitsOf(downs), up = bitsOf(ups);
        if (down != 0) {
            addSide((oldLow - low) & downs, down, left, oldLow + low, u, v, sums, all);
            store(downs ? low : oldLow, gap.low);
        }
        if (up != 0) {
            addSide((high - oldHigh) & ups, up, right, oldHigh + high, u, v, sums, all);
            store(ups ? high : oldHigh, gap.high);
        }
        growth.cutLanes[i] = down | up;
        growth.open[open] = i;
        growth.openLanes[open] = bitsOf(hit & ~within);
        open += growth.openLanes[open] != 0 ? 1 : 0;
    }
    growth.openCount = open;
    store(all.units, sums.units);
    store(all.momentU, sums.momentU);
    store(all.momentV, sums.momentV);
    store(all.momentAlong, sums.momentAlong);
}

} // namespace burin::kernels
