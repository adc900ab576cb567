// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0

// Of gap_window_kernels.cpp, which includes it once for each kind of processor, in a namespace that says what a Mask
// is.

/// What one side of a row's gaps lost, lane by lane. Neighbours of one property are the rule: their units stay in a
/// register until another one comes.
struct Side {
    Integers property{}; ///< of `units`, the same in every lane
    Integers units{};    ///< run units
    Floats momentAlong{};
};

BURIN_INLINE void flush(GapWindow::Sums& sums, Side& lost) noexcept {
    const auto place = static_cast<std::size_t>(lost.property[0]);
    store(load(sums.byProperty[place]) + lost.units, sums.byProperty[place]);
    sums.used[place / 64] |= std::uint64_t{1} << (place % 64);
    lost.units = Integers{};
}

/// Adds what eight gaps lost. `middle`: of it, doubled, run units from the origin. @return units as floats
BURIN_INLINE Floats addSide(Integers taken, Words neighbour, Integers middle, GapWindow::Sums& sums,
                            Side& lost) noexcept {
    const auto property = reinterpret_cast<Integers>(neighbour & 255U);
    const Mask others = unlike(property, lost.property) & greater(taken, Integers{});
    if (std::uint32_t left = bitsOf(others); left == 0) {
        lost.units += taken;
    } else {
        lost.units += select(others, Integers{}, taken);
        do {
            flush(sums, lost);
            lost.property = integers(property[std::countr_zero(left)]);
            const Mask same = others & ~unlike(property, lost.property);
            lost.units = select(same, taken, Integers{});
            left &= ~bitsOf(same);
        } while (left != 0);
    }
    const Floats units = floatsOf(taken);
    lost.momentAlong += units * floatsOf(middle);
    return units;
}

/// What rows lost, from the sums' origins.
struct Lost {
    Side below, above;
    Floats units{}, momentU{}, momentV{}; ///< momentU without the lanes' own places
};

/// The next row's place: rows are too short for the processor to see where they lead.
BURIN_INLINE void prefetch(const GapWindow::Gap& gap) noexcept {
    __builtin_prefetch(&gap.low);
    __builtin_prefetch(&gap.left);
}

/// Eight lines of which some spans reach out of their gaps.
struct Grown {
    Floats units;       ///< that were taken
    std::uint32_t open; ///< bits of the lines that need the volume
};

/// Grows gaps downwards. @param hits lines whose spans begin below their gaps; `high` lies beyond none of these
BURIN_INLINE Grown growDown(GapWindow::Gap& gap, Integers low, Integers high, Integers oldLow, Mask hits,
                            Integers alongOrigin, GapWindow::Sums& sums, Lost& lost) noexcept {
    const Words left = load(gap.left);
    const Mask apart = greater(oldLow, high) | greater(least(oldLow, reinterpret_cast<Integers>(left >> 8)), low);
    const Integers newLow = select(hits & ~apart, low, oldLow);
    store(newLow, gap.low);
    return {addSide(oldLow - newLow, left, oldLow + newLow - alongOrigin, sums, lost.below), bitsOf(hits & apart)};
}

/// And upwards.
BURIN_INLINE Grown growUp(GapWindow::Gap& gap, Integers low, Integers high, Integers oldHigh, Mask hits,
                          Integers alongOrigin, GapWindow::Sums& sums, Lost& lost) noexcept {
    const Words right = load(gap.right);
    const Mask apart = greater(low, oldHigh) | greater(high, most(oldHigh, reinterpret_cast<Integers>(right >> 8)));
    const Integers newHigh = select(hits & ~apart, high, oldHigh);
    store(newHigh, gap.high);
    return {addSide(newHigh - oldHigh, right, oldHigh + newHigh - alongOrigin, sums, lost.above), bitsOf(hits & apart)};
}

BURIN_INLINE Grown growBothWays(GapWindow::Gap& gap, Integers low, Integers high, Integers oldLow, Integers oldHigh,
                                Mask hits, Integers alongOrigin, GapWindow::Sums& sums, Lost& lost) noexcept {
    const Words left = load(gap.left), right = load(gap.right);
    const Mask apart = greater(low, oldHigh) | greater(oldLow, high) |
                       greater(high, most(oldHigh, reinterpret_cast<Integers>(right >> 8))) |
                       greater(least(oldLow, reinterpret_cast<Integers>(left >> 8)), low);
    const Mask grows = hits & ~apart;
    const Integers newLow = select(grows, least(low, oldLow), oldLow);
    const Integers newHigh = select(grows, most(high, oldHigh), oldHigh);
    store(newLow, gap.low);
    store(newHigh, gap.high);
    return {addSide(oldLow - newLow, left, oldLow + newLow - alongOrigin, sums, lost.below) +
                addSide(newHigh - oldHigh, right, oldHigh + newHigh - alongOrigin, sums, lost.above),
            bitsOf(hits & apart)};
}

/// Goes on with a row. Most spans reach out of their gaps on one side alone. @return the first group that it did not
/// come to
BURIN_INLINE std::int32_t growRow(const GapWindow::Rows& rows, const RowSpans& row, GapWindow::Sums& sums, Lost& lost,
                                  Growth& growth) noexcept {
    // What the stores below can't change, as far as the compiler knows.
    const EightIntegers *const lows = row.low, *const highs = row.high;
    const std::size_t rowPitch = rows.rowPitch;
    GapWindow::Gap* const gaps = rows.gaps + rowPitch * static_cast<std::size_t>(row.v & 7);
    GapWindow::Brick* const bricks = rows.bricks;
    const std::uint32_t firstGroup = static_cast<std::uint32_t>(row.firstGroup), mask = rows.mask;
    const std::int32_t groups = row.groups, originU = row.firstGroup * lanes - sums.originU;
    const Integers alongOrigin = integers(sums.alongOrigin);
    const int shift = (row.v & 7) * 8;
    Floats rowUnits{};
    std::int32_t group = growth.group;
    for (; group < groups; ++group) {
        const std::uint32_t place = (firstGroup + static_cast<std::uint32_t>(group)) & mask;
        GapWindow::Gap& gap = gaps[place];
        prefetch((&gap)[rowPitch]);
        const Integers low = load(lows[group]), high = load(highs[group]);
        const Integers oldLow = load(gap.low), oldHigh = load(gap.high);
        const Mask there = greater(high, low), below = greater(oldLow, low) & there,
                   above = greater(high, oldHigh) & there;
        const std::uint32_t down = bitsOf(below), up = bitsOf(above);
        if ((down | up) == 0) continue;
        GapWindow::Brick& brick = bricks[place];
        if (!brick.ready) break;
        const Grown grown = up == 0 ? growDown(gap, low, high, oldLow, below, alongOrigin, sums, lost)
                            : down == 0
                                ? growUp(gap, low, high, oldHigh, above, alongOrigin, sums, lost)
                                : growBothWays(gap, low, high, oldLow, oldHigh, below | above, alongOrigin, sums, lost);
        rowUnits += grown.units;
        lost.momentU += grown.units * static_cast<float>(group * lanes + originU);
        brick.owing |= static_cast<std::uint64_t>((down | up) & ~grown.open) << shift;
        if (grown.open != 0)
            growth.open[growth.openCount++] = {static_cast<std::uint16_t>(growth.row),
                                               static_cast<std::uint16_t>(group), grown.open};
    }
    lost.units += rowUnits;
    lost.momentV += rowUnits * static_cast<float>(row.v - sums.originV);
    return group;
}

BURIN_INLINE void addTo(GapWindow::Sums& sums, Lost& lost) noexcept {
    flush(sums, lost.below);
    flush(sums, lost.above);
    const Floats lane{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
    store(load(sums.units) + lost.units, sums.units);
    store(load(sums.momentU) + lost.momentU + lost.units * lane, sums.momentU);
    store(load(sums.momentV) + lost.momentV, sums.momentV);
    store(load(sums.momentAlong) + lost.below.momentAlong + lost.above.momentAlong, sums.momentAlong);
}

/// See growGaps.
BURIN_INLINE bool growAll(const GapWindow::Rows& rows, GapWindow::Sums& sums, Growth& growth) noexcept {
    Lost lost;
    for (; growth.row < rows.spans.size(); ++growth.row, growth.group = 0) {
        const RowSpans& row = rows.spans[growth.row];
        growth.group = growRow(rows, row, sums, lost, growth);
        if (growth.group < row.groups) break;
    }
    addTo(sums, lost);
    return growth.row == rows.spans.size();
}
