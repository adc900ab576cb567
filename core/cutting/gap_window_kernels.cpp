// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/gap_window_kernels.h"

#include <bit>

namespace burin::kernels {

namespace {

/// What one side of a row's gaps lost, lane by lane. Neighbours of one property are the rule: their units stay in a
/// register until another one comes.
struct Side {
    Integers property{};     ///< of `units`, the same in every lane
    Integers units{}, all{}; ///< of that property; of those before it, run units
    Floats momentAlong{};
};

BURIN_INLINE void flush(GapWindow::Sums& sums, Side& lost) noexcept {
    const auto place = static_cast<std::size_t>(lost.property[0]);
    store(load(sums.byProperty[place]) + lost.units, sums.byProperty[place]);
    sums.used[place / 64] |= std::uint64_t{1} << (place % 64);
    lost.all += lost.units;
    lost.units = Integers{};
}

/// Adds what eight gaps lost. `middle`: of it, doubled, run units from the origin. @return units as floats
BURIN_INLINE Floats addSide(Integers taken, Words neighbour, Integers middle, GapWindow::Sums& sums,
                            Side& lost) noexcept {
    const auto property = reinterpret_cast<Integers>(neighbour & 255U);
    const Integers others = (property != lost.property) & (taken > Integers{});
    if (std::uint32_t left = bitsOf(others); left == 0) {
        lost.units += taken;
    } else {
        lost.units += taken & ~others;
        do {
            flush(sums, lost);
            lost.property = integers(property[std::countr_zero(left)]);
            const Integers same = (property == lost.property) & others;
            lost.units = taken & same;
            left &= ~bitsOf(same);
        } while (left != 0);
    }
    const Floats units = floatsOf(taken);
    lost.momentAlong += units * floatsOf(middle);
    return units;
}

/// Adds a row's sums to those of the rows before it. `momentU` without the lanes' own places.
BURIN_INLINE void addRow(std::int32_t v, Floats momentU, GapWindow::Sums& sums, Side& below, Side& above) noexcept {
    flush(sums, below);
    flush(sums, above);
    const Floats units = floatsOf(below.all + above.all);
    const Floats lane{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
    store(load(sums.units) + units, sums.units);
    store(load(sums.momentU) + momentU + units * lane, sums.momentU);
    store(load(sums.momentV) + units * static_cast<float>(v - sums.originV), sums.momentV);
    store(load(sums.momentAlong) + below.momentAlong + above.momentAlong, sums.momentAlong);
}

} // namespace

BURIN_VECTORISED std::int32_t growGaps(const GapWindow::Row& row, std::int32_t group, GapWindow::Sums& sums,
                                       Growth& growth) noexcept {
    // What the stores below can't change, as far as the compiler knows.
    const EightIntegers *const lows = row.low, *const highs = row.high;
    GapWindow::Gap* const gaps = row.gaps;
    GapWindow::Brick* const bricks = row.bricks;
    const std::uint32_t firstGroup = static_cast<std::uint32_t>(row.firstGroup), mask = row.mask;
    const std::int32_t groups = row.groups, originU = sums.originU;
    const Integers alongOrigin = integers(sums.alongOrigin);
    const int shift = row.shift;
    Side below, above;
    Floats momentU{};
    for (; group < groups; ++group) {
        const std::uint32_t place = (firstGroup + static_cast<std::uint32_t>(group)) & mask;
        GapWindow::Gap& gap = gaps[place];
        const Integers low = load(lows[group]), high = load(highs[group]);
        const Integers oldLow = load(gap.low), oldHigh = load(gap.high);
        const Integers hit = ((oldLow > low) | (high > oldHigh)) & (high > low);
        const std::uint32_t hits = bitsOf(hit);
        if (hits == 0) continue;
        GapWindow::Brick& brick = bricks[place];
        if (!brick.ready) break;
        const Words left = load(gap.left), right = load(gap.right);
        const Integers apart = (low > oldHigh) | (oldLow > high) |
                               (high > most(oldHigh, reinterpret_cast<Integers>(right >> 8))) |
                               (least(oldLow, reinterpret_cast<Integers>(left >> 8)) > low);
        const Integers grows = hit & ~apart;
        const Integers newLow = grows ? least(low, oldLow) : oldLow, newHigh = grows ? most(high, oldHigh) : oldHigh;
        store(newLow, gap.low);
        store(newHigh, gap.high);
        const Floats units = addSide(oldLow - newLow, left, oldLow + newLow - alongOrigin, sums, below) +
                             addSide(newHigh - oldHigh, right, oldHigh + newHigh - alongOrigin, sums, above);
        momentU += units * static_cast<float>((row.firstGroup + group) * lanes - originU);
        const std::uint32_t open = bitsOf(hit & apart);
        brick.owing |= static_cast<std::uint64_t>(hits & ~open) << shift;
        if (open != 0) {
            growth.open[growth.openCount] = group;
            growth.openLanes[growth.openCount++] = open;
        }
    }
    addRow(row.v, momentU, sums, below, above);
    return group;
}

} // namespace burin::kernels
