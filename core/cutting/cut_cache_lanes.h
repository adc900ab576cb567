// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0

// Part of gap_window_kernels.cpp, which includes it once for each width of registers (core/base/whole_registers.h).
// Processes two rows of lines at once, or one after the other; alternate rows are summed separately, so that both give
// the same bits.

constexpr std::size_t lanesAtOnce = 16; // of two rows
constexpr std::size_t parts = lanesAtOnce / width;

/// The loss on one side of gaps, lane by lane. The neighbours mostly have one property: their units stay in a register
/// until another property comes.
struct Side {
    Integers property{}; ///< of `units`, the same in every lane
    Integers units{};    ///< run units
    Floats momentAlong{};
};

/// The loss of some lines, relative to the origins of the sums; along v relative to the row of bricks.
struct Lost {
    Side below, above;
    Floats units{}, momentU{}, momentV{}; ///< momentU without the positions of the lanes
};

/// @param part index within the two rows
BURIN_INLINE void flush(CutCache::Sums& sums, Side& lost, std::size_t part) noexcept {
    const auto place = static_cast<std::size_t>(lost.property[0]);
    std::int32_t* const of = sums.byProperty[place].data() + part * width;
    storeAt(lanesAt<Integers>(of) + lost.units, of);
    sums.used[place / 64] |= std::uint64_t{1} << (place % 64);
    lost.units = Integers{};
}

/// Adds what gaps lost. `grown`: the lanes that lost any; `middle`: the middle of the loss, doubled, run units from the
/// origin. @return units as floats
BURIN_INLINE Floats addSide(Integers taken, Mask grown, Words neighbour, Integers middle, CutCache::Sums& sums,
                            Side& lost, std::size_t part) noexcept {
    const auto property = reinterpret_cast<Integers>(neighbour & 255U);
    const Mask others = unlike(property, lost.property) & grown;
    if (std::uint32_t left = bitsOf(others); left == 0) {
        lost.units += taken;
    } else {
        lost.units += select(others, Integers{}, taken);
        do {
            flush(sums, lost, part);
            lost.property = each(property[std::countr_zero(left)]);
            const Mask same = others & ~unlike(property, lost.property);
            lost.units = select(same, taken, Integers{});
            left &= ~bitsOf(same);
        } while (left != 0);
    }
    const Floats units = floatsOf(taken);
    lost.momentAlong += units * floatsOf(middle);
    return units;
}

/// Lines of a brick, some of whose spans extend beyond their gaps.
struct Lines {
    std::int32_t *lows, *highs; ///< of their gaps
    const std::uint32_t *lefts, *rights;
    Integers low, high, oldLow, oldHigh;
    Integers alongOrigin;
    std::size_t part;
};

struct Grown {
    Floats units;       ///< removed units
    std::uint32_t open; ///< bits of the lines that need the volume
};

/// Grows gaps downwards. @param hits lines whose spans begin below their gaps; none of these spans ends above its gap
BURIN_INLINE Grown growDown(const Lines& at, Mask hits, CutCache::Sums& sums, Lost& lost) noexcept {
    const auto left = lanesAt<Words>(at.lefts);
    const Mask apart =
        greater(at.oldLow, at.high) | greater(least(at.oldLow, reinterpret_cast<Integers>(left >> 8)), at.low);
    const Mask grows = hits & ~apart;
    const Integers newLow = select(grows, at.low, at.oldLow);
    storeAt(newLow, at.lows);
    return {addSide(at.oldLow - newLow, grows, left, at.oldLow + newLow - at.alongOrigin, sums, lost.below, at.part),
            bitsOf(hits & apart)};
}

/// Grows gaps upwards.
BURIN_INLINE Grown growUp(const Lines& at, Mask hits, CutCache::Sums& sums, Lost& lost) noexcept {
    const auto right = lanesAt<Words>(at.rights);
    const Mask apart =
        greater(at.low, at.oldHigh) | greater(at.high, most(at.oldHigh, reinterpret_cast<Integers>(right >> 8)));
    const Mask grows = hits & ~apart;
    const Integers newHigh = select(grows, at.high, at.oldHigh);
    storeAt(newHigh, at.highs);
    return {
        addSide(newHigh - at.oldHigh, grows, right, at.oldHigh + newHigh - at.alongOrigin, sums, lost.above, at.part),
        bitsOf(hits & apart)};
}

BURIN_INLINE Grown growBothWays(const Lines& at, Mask below, Mask above, CutCache::Sums& sums, Lost& lost) noexcept {
    const auto left = lanesAt<Words>(at.lefts), right = lanesAt<Words>(at.rights);
    const Mask apart = greater(at.low, at.oldHigh) | greater(at.oldLow, at.high) |
                       greater(at.high, most(at.oldHigh, reinterpret_cast<Integers>(right >> 8))) |
                       greater(least(at.oldLow, reinterpret_cast<Integers>(left >> 8)), at.low);
    const Mask down = below & ~apart, up = above & ~apart;
    const Integers newLow = select(down, at.low, at.oldLow), newHigh = select(up, at.high, at.oldHigh);
    storeAt(newLow, at.lows);
    storeAt(newHigh, at.highs);
    return {
        addSide(at.oldLow - newLow, down, left, at.oldLow + newLow - at.alongOrigin, sums, lost.below, at.part) +
            addSide(newHigh - at.oldHigh, up, right, at.oldHigh + newHigh - at.alongOrigin, sums, lost.above, at.part),
        bitsOf((below | above) & apart)};
}

BURIN_INLINE void keepOpen(std::int32_t brick, std::int32_t row, std::uint32_t open, Growth& growth) noexcept {
    for (; open != 0; open >>= lanes, ++row)
        if ((open & 255U) != 0) growth.open[growth.openCount++] = {brick, row, open & 255U};
}

/// Returns the bits of the lines of some rows.
BURIN_INLINE std::uint64_t linesOf(std::uint32_t rows) noexcept {
    constexpr std::uint64_t apart = 0x0002040810204081, lowest = 0x0101010101010101; // bit i to 8 i
    return ((((rows & 127U) * apart) & lowest) | static_cast<std::uint64_t>(rows >> 7) << 56) * 255U;
}

/// The origin of the sums.
struct Origin {
    Integers along;
    std::int32_t u;
};

/// Removes the parts of spans beyond the gaps of a brick, most of them on one side only. Returns false if the brick is
/// not ready.
BURIN_INLINE bool growBrick(const CutCache::BrickRow& row, const Origin& origin, CutCache::Sums& sums,
                            Lost (&lost)[parts], Growth& growth) noexcept {
    const std::uint32_t place = static_cast<std::uint32_t>(growth.brick) & row.mask;
    CutCache::Gaps& gaps = row.gaps[place];
    CutCache::Brick& brick = row.bricks[place];
    const BrickOfSpans& spans = row.spans[growth.brick - row.first];
    const std::uint64_t asked = linesOf(row.asked(growth.brick));
    Floats units[parts]{}, before[parts]{};
    std::uint64_t cut = 0;
    for (std::int32_t pair = 0; pair < lanes; pair += 2) {
        for (std::size_t part = 0; part < parts; ++part) before[part] += units[part];
        if ((asked >> (pair * lanes) & 0xffffU) == 0) continue;
#pragma GCC unroll 2
        for (std::size_t part = 0; part < parts; ++part) {
            const std::int32_t firstRow = pair + static_cast<std::int32_t>(part);
            const auto at = static_cast<std::size_t>(firstRow * lanes);
            const auto low = lanesAt<Integers>(spans.low[firstRow].lane),
                       high = lanesAt<Integers>(spans.high[firstRow].lane);
            const auto oldLow = lanesAt<Integers>(&gaps.low[at]), oldHigh = lanesAt<Integers>(&gaps.high[at]);
            const Mask there = greater(high, low) & lanesOf(asked >> at);
            const Mask below = greater(oldLow, low) & there, above = greater(high, oldHigh) & there;
            const std::uint32_t down = bitsOf(below), up = bitsOf(above);
            if ((down | up) == 0) continue;
            if (!brick.ready) return false; // nothing of this brick was removed
            const Lines lines{&gaps.low[at], &gaps.high[at], &gaps.left[at], &gaps.right[at], low,
                              high,          oldLow,         oldHigh,        origin.along,    part};
            const Grown grown = up == 0     ? growDown(lines, below, sums, lost[part])
                                : down == 0 ? growUp(lines, above, sums, lost[part])
                                            : growBothWays(lines, below, above, sums, lost[part]);
            units[part] += grown.units;
            cut |= static_cast<std::uint64_t>((down | up) & ~grown.open) << at;
            if (grown.open != 0) keepOpen(growth.brick, firstRow, grown.open, growth);
        }
    }
    brick.owing |= cut;
    const auto momentArm = static_cast<float>(growth.brick * lanes - origin.u);
    for (std::size_t part = 0; part < parts; ++part) {
        lost[part].units += units[part];
        lost[part].momentU += units[part] * momentArm;
        // The units of a pair were counted once for each later pair: those of the last pair, row 6, not at all.
        const Floats even = units[part] * (eightNumbers() + static_cast<float>(6 + part));
        lost[part].momentV += even - 2.0F * before[part];
    }
    return true;
}

BURIN_INLINE void addTo(CutCache::Sums& sums, Lost& lost, float momentArmV, std::size_t part) noexcept {
    flush(sums, lost.below, part);
    flush(sums, lost.above, part);
    const auto add = [&](Floats sum, CutCache::Sums::Lanes<float>& to) {
        float* const of = to.data() + part * width;
        storeAt(lanesAt<Floats>(of) + sum, of);
    };
    add(lost.units, sums.units);
    add(lost.momentU + lost.units * floatsOf(numbers() & each(lanes - 1)), sums.momentU);
    add(lost.momentV + lost.units * momentArmV, sums.momentV);
    add(lost.below.momentAlong + lost.above.momentAlong, sums.momentAlong);
}

/// See growGaps.
BURIN_INLINE bool growAll(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept {
    const CutCache::BrickRow own = row; // a copy, which the stores can't change
    const Origin origin{each(sums.alongOrigin), sums.originU};
    Lost lost[parts];
    while (growth.brick < own.end && growBrick(own, origin, sums, lost, growth)) ++growth.brick;
    for (std::size_t part = 0; part < parts; ++part)
        addTo(sums, lost[part], static_cast<float>(row.firstLine - sums.originV), part);
    return growth.brick == row.end;
}
