// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0

// Part of span_rows_upright.cpp, which includes it once for each register width (core/base/whole_registers.h):
// processes one row of lines at a time, or two. The result for a line does not depend on its neighbours, and thus not
// on the width either.

constexpr int cornerSteps = 10;

/// Returns the height of the rounding below its middle, voxels. @param inside R² - r² of the lines, voxels²
template <Shape shape>
BURIN_INLINE Floats drop(const Upright& piece, Floats inside) noexcept {
    if constexpr (shape == Shape::ball) return rootsOf(inside);
    // (corner - over)(corner + over), over = r - flat; corner - over = R - r without cancellation.
    const Floats radius = rootsOf(piece.radius * piece.radius - inside);
    const Floats over = most(radius - piece.flatRadius, Floats{});
    const Floats left = least(inside / (piece.radius + radius), each(piece.cornerRadius));
    return rootsOf(left * (piece.cornerRadius + over));
}

/// Returns the lower face at one end of the move, units above the rounding's middle there. `inside`: R² - r².
template <Shape shape>
BURIN_INLINE Floats lowAtEnd(const Upright& piece, const End& end, Floats inside) noexcept {
    const Integers covered = inside > Floats{};
    if constexpr (shape == Shape::flat) return covered ? each(end.flatHeight) : each(nowhere);
    Floats height = -unitsAVoxel * drop<shape>(piece, inside);
    if constexpr (shape == Shape::bullNose) {
        const Floats flatInside = each(piece.radius * piece.radius - piece.flatRadius * piece.flatRadius);
        height = inside >= flatInside ? each(end.flatHeight) : height;
    }
    return covered ? height : each(nowhere);
}

/// A line relative to the move: `ahead` along it from the start, `chord` half of the distance over which the piece
/// covers the line.
struct FromWay {
    Floats ahead, chord, asideSquare;
    Integers meets; ///< all bits or none

    /// Whether the piece covers the line between the ends, except where an end that covers it gives the same result. A
    /// line can lie on the outline at one end and next to the axis at the other: no end covers it, but the move does.
    /// @param part of the move at which the face counts
    /// @param atFirst the face counts as early in the move as possible, otherwise as late as possible
    BURIN_INLINE Integers isPassed(const Upright& piece, Floats part, bool atFirst) const noexcept {
        const Floats zero{};
        const Integers behindEnd = ahead<each(piece.reach), beforeStart = ahead> zero;
        return meets &
               (atFirst ? beforeStart & (behindEnd | (part < each(1.0F))) : behindEnd & (beforeStart | (part > zero)));
    }
};

/// Returns the offset from axis to line at which a rising bull nose is lowest over the line, between two bounds: the
/// zero of an increasing function, by false position, with every second step a bisection.
BURIN_INLINE Floats cornerOffset(const Upright& piece, Floats asideSquare, Floats low, Floats high) noexcept {
    const Floats rise = each(piece.rise < 0.0F ? -piece.sine : piece.sine);
    // Over the flat middle the height does not decrease.
    const Floats flatEdge = rootsOf(piece.flatRadius * piece.flatRadius - asideSquare);
    low = least(most(low, flatEdge), high);
    const auto excess = [&](Floats offset) __attribute__((always_inline)) {
        const Floats radius = rootsOf(asideSquare + offset * offset);
        const Floats over = least(most(radius - piece.flatRadius, Floats{}), each(piece.cornerRadius));
        const Floats below = rootsOf((piece.cornerRadius - over) * (piece.cornerRadius + over));
        const Floats grown = piece.cosine * over * offset - rise * below * radius;
        return over > Floats{} ? grown : each(-piece.cornerRadius);
    };
    Floats atLow = excess(low), atHigh = excess(high);
    const Integers lowBest = atLow >= Floats{}, highBest = atHigh <= Floats{};
    const Floats first = low, last = high;
    for (int step = 0; step < cornerSteps; ++step) {
        const Floats bend = atHigh - atLow;
        const Floats part = step % 2 == 0 ? least(most(-atLow / bend, Floats{}), each(1.0F)) : each(0.5F);
        const Floats next = low + part * (high - low);
        const Floats there = excess(next);
        const Integers before = there < Floats{};
        low = before ? next : low;
        atLow = before ? there : atLow;
        high = before ? high : next;
        atHigh = before ? atHigh : there;
    }
    const Floats middle = 0.5F * (low + high);
    return highBest ? last : lowBest ? first : middle;
}

/// Returns the lower face between the ends, units above the rounding's middle at the end.
template <Shape shape>
BURIN_INLINE Floats lowBetween(const Upright& piece, const FromWay& line) noexcept {
    const Floats zero{}, one = each(1.0F);
    if constexpr (shape == Shape::ball) {
        const Floats part = (line.ahead - piece.sine * line.chord) * piece.perReach;
        const Integers valid = line.meets & (part > zero) & (part < one);
        return valid ? piece.rise * (part - one) - (unitsAVoxel * piece.cosine) * line.chord : each(nowhere);
    }
    const bool atFirst = !(piece.rise < 0.0F);
    if constexpr (shape == Shape::flat) {
        const Floats part = (line.ahead - piece.riseSign * line.chord) * piece.perReach;
        const Integers valid = line.isPassed(piece, part, atFirst);
        return valid ? piece.to.flatHeight + piece.rise * (least(most(part, zero), one) - one) : each(nowhere);
    }
    Floats offset = zero;
    const Floats first = most(line.ahead - piece.reach, -line.chord), last = least(line.ahead, line.chord);
    if (piece.rise > 0.0F)
        offset = cornerOffset(piece, line.asideSquare, most(first, zero), last);
    else if (piece.rise < 0.0F)
        offset = -cornerOffset(piece, line.asideSquare, most(-last, zero), -first);
    offset = least(most(offset, first), last);
    const Floats part = (line.ahead - offset) * piece.perReach;
    const Integers valid = (first < last) & line.isPassed(piece, part, atFirst);
    const Floats inside = piece.radius * piece.radius - line.asideSquare - offset * offset;
    const Floats height = piece.rise * (least(most(part, zero), one) - one) - unitsAVoxel * drop<shape>(piece, inside);
    return valid ? height : each(nowhere);
}

/// Returns the upper face between the ends, units; it is flat.
BURIN_INLINE Integers highBetween(const Upright& piece, const FromWay& line) noexcept {
    const Floats zero{}, one = each(1.0F);
    const Floats part = (line.ahead + piece.riseSign * line.chord) * piece.perReach;
    const Integers valid = line.isPassed(piece, part, piece.rise < 0.0F);
    const Floats height = piece.rise * (least(most(part, zero), one) - one);
    return valid ? wholeOf(piece.topMiddle + height) + piece.topBase : each(-SpanRows::none);
}

/// The values that depend only on the rows.
struct Row {
    Floats fromSquare, toSquare; ///< R² - y² at both ends, voxels²
    Floats ahead, aside;         ///< of the line at the start's x, relative to the start
};

/// Groups of an interval, counted from its first.
struct Groups {
    std::int32_t first = 0, end = 0;
    /// Returns the groups of another interval that lie within this one.
    BURIN_INLINE Groups held(std::int32_t otherFirst, std::int32_t otherEnd) const noexcept {
        const auto within = [&](std::int32_t group) { return group < first ? first : group < end ? group : end; };
        return {within(otherFirst), within(otherEnd)};
    }
};

/// Whether the upper face is at one height wherever the lower one is, or both of its heights count.
enum class Top : bool { level, rises };

/// Iterates along a row, group by group.
struct Cursor {
    Floats u; ///< integer number of lines from the end of the move
    BrickOfSpans* brick;
    std::size_t row; ///< of the brick

    BURIN_INLINE void put(Integers lowEnd, Integers highEnd) noexcept {
        storeAt(lowEnd, brick->low[row].lane);
        storeAt(highEnd, brick->high[row].lane);
        ++brick;
        u += lanes;
    }
};

BURIN_INLINE std::int32_t lesser(std::int32_t a, std::int32_t b) noexcept {
    return a < b ? a : b;
}

BURIN_INLINE std::int32_t greaterOf(std::int32_t a, std::int32_t b) noexcept {
    return a > b ? a : b;
}

/// Covers lines on which the piece is lowest at the end of the move: everything except the upper end follows from that.
template <Shape shape>
BURIN_INLINE void coverEnd(const Upright& piece, const Row& row, Cursor& cursor, std::int32_t groups,
                           std::int32_t top) noexcept {
    if (groups <= 0) return;
    const Floats part = each(piece.to.partX), square = row.toSquare, middle = each(piece.to.middle);
    const Integers base = each(piece.to.base), high = each(lesser(top, piece.lineEnd));
    const Upright shapeOnly = piece; // a copy that the stores can't alias
    const End end = piece.to;
    for (; groups > 0; --groups) {
        const Floats x = cursor.u - part;
        const Floats height = lowAtEnd<shape>(shapeOnly, end, square - x * x);
        cursor.put(most(wholeOf(height + middle) + base, Integers{}), high);
    }
}

/// Covers lines behind the axis of a rising piece: only its upper face moves there.
BURIN_INLINE void coverTop(const Upright& piece, Cursor& cursor, std::int32_t groups) noexcept {
    if (groups <= 0) return;
    const Integers low = each(piece.from.top > 0 ? piece.from.top : 0);
    const Integers high = each(lesser(piece.to.top, piece.lineEnd));
    for (; groups > 0; --groups) cursor.put(low, high);
}

template <Shape shape, bool withStart, bool moves, Top top>
BURIN_INLINE void cover(const Upright& piece, const Row& row, Cursor& cursor, std::int32_t groups,
                        std::int32_t levelTop) noexcept {
    if (groups <= 0) return;
    const Upright own = piece; // a copy that the stores can't alias
    const Integers level = each(lesser(levelTop, own.lineEnd));
    const auto between = static_cast<float>(own.to.wholeX - own.from.wholeX);
    for (; groups > 0; --groups) {
        const Floats toX = cursor.u - own.to.partX, fromX = (cursor.u + between) - own.from.partX;
        const Floats toInside = row.toSquare - toX * toX, fromInside = row.fromSquare - fromX * fromX;
        FromWay line{};
        Floats height = lowAtEnd<shape>(own, own.to, toInside);
        if constexpr (moves) {
            const Floats aside = row.aside - fromX * own.wayY;
            const Floats inside = (own.radius - aside) * (own.radius + aside);
            line = {fromX * own.wayX + row.ahead, rootsOf(inside), aside * aside, inside > Floats{}};
            height = least(height, lowBetween<shape>(own, line));
        }
        Integers low = wholeOf(height + own.to.middle) + own.to.base;
        Integers high = level;
        if constexpr (withStart) {
            const Floats start = lowAtEnd<shape>(own, own.from, fromInside);
            low = least(low, wholeOf(start + own.from.middle) + own.from.base);
        }
        if constexpr (top == Top::rises) {
            high = toInside > Floats{} ? each(own.to.top) : each(-SpanRows::none);
            // Not higher than at the ends, despite rounding: lines that are covered there agree on the height.
            if constexpr (moves) high = most(high, least(highBetween(own, line), each(own.highestTop)));
            // What was left behind at the start adjoins what is beyond it.
            const Integers started = fromInside > Floats{};
            low = started ? least(low, each(own.from.top)) : low;
            high = least(started ? most(high, each(own.from.top)) : high, each(own.lineEnd));
        }
        cursor.put(most(low, Integers{}), high);
    }
}

/// Covers lines for a piece that moves below an upper face at one height. @param between groups where a ball can be
/// lowest between the ends
template <Shape shape, bool withStart>
BURIN_INLINE void coverMoving(const Upright& piece, const Row& row, Cursor& cursor, Groups groups, Groups between,
                              std::int32_t top) noexcept {
    // Dividing a short row into more parts would cost more than it saves.
    constexpr std::int32_t shortRow = 4;
    const bool splits = shape == Shape::ball && !withStart && groups.end - groups.first > shortRow;
    between = splits ? groups.held(between.first, between.end) : groups;
    coverEnd<shape>(piece, row, cursor, between.first - groups.first, top);
    cover<shape, withStart, true, Top::level>(piece, row, cursor, between.end - between.first, top);
    coverEnd<shape>(piece, row, cursor, groups.end - between.end, top);
}

/// Covers lines for a piece that continues from its previous position, with its upper face at two heights within the
/// stock. On lines that it covers during the entire move, the higher one counts; if the piece rises, nothing else is
/// new behind its axis.
template <Shape shape>
BURIN_INLINE void coverGoingOn(const Upright& piece, const Row& row, Cursor& cursor, Groups all, Groups covered,
                               Groups deeper, Groups between) noexcept {
    deeper = covered.held(deeper.first, deeper.end);
    cover<shape, false, true, Top::rises>(piece, row, cursor, covered.first, 0);
    coverTop(piece, cursor, deeper.first - covered.first);
    coverMoving<shape, false>(piece, row, cursor, deeper, between, piece.highestTop);
    coverTop(piece, cursor, covered.end - deeper.end);
    cover<shape, false, true, Top::rises>(piece, row, cursor, all.end - covered.end, 0);
}

/// Adjacent requested rows, at most as many as a register holds; or a single row.
struct Strip {
    const RowSpans &one, &other; ///< the same if there is only one

    BURIN_INLINE static std::size_t at(const Rows& rows, const RowSpans& row) noexcept {
        return static_cast<std::size_t>(row.v - rows.first);
    }
    BURIN_INLINE Groups all() const noexcept {
        return {lesser(one.firstGroup, other.firstGroup),
                greaterOf(one.firstGroup + one.groups, other.firstGroup + other.groups)};
    }
    BURIN_INLINE Floats of(const Rows& rows, const Rows::Numbers& values) const noexcept {
        return eachEight(values[at(rows, one)], values[at(rows, other)]);
    }
    /// Returns the groups of either row.
    BURIN_INLINE Groups either(const Rows& rows, const Rows::Groups& begins, const Rows::Groups& ends,
                               std::int32_t origin) const noexcept {
        const std::size_t i = at(rows, one), j = at(rows, other);
        return {lesser(begins[i], begins[j]) - origin, greaterOf(ends[i], ends[j]) - origin};
    }
    /// Returns the groups of both rows.
    BURIN_INLINE Groups both(const Rows& rows, const Rows::Groups& begins, const Rows::Groups& ends,
                             std::int32_t origin) const noexcept {
        const std::size_t i = at(rows, one), j = at(rows, other);
        return {greaterOf(begins[i], begins[j]) - origin, lesser(ends[i], ends[j]) - origin};
    }
};

template <Shape shape>
BURIN_INLINE void coverStrip(const Upright& piece, const Rows& rows, const Strip& strip) noexcept {
    const Row row{strip.of(rows, rows.fromSquare), strip.of(rows, rows.toSquare), strip.of(rows, rows.ahead),
                  strip.of(rows, rows.aside)};
    const Groups asked = strip.all(), all{0, asked.end - asked.first};
    const std::int32_t origin = asked.first;
    const Groups between = strip.either(rows, rows.betweenBegin, rows.betweenEnd, origin);
    constexpr std::int32_t rowsOfRegister = width / lanes;
    Cursor cursor{floatsOf((numbers() & each(lanes - 1)) + (origin * lanes - piece.to.wholeX)),
                  strip.one.bricks + (origin - strip.one.firstGroup),
                  static_cast<std::size_t>(strip.one.v & (lanes - rowsOfRegister))};
    if (piece.topRises) {
        if (piece.withStart)
            piece.moves ? cover<shape, true, true, Top::rises>(piece, row, cursor, all.end, 0)
                        : cover<shape, true, false, Top::rises>(piece, row, cursor, all.end, 0);
        else if (!piece.moves)
            cover<shape, false, false, Top::rises>(piece, row, cursor, all.end, 0);
        else {
            const Groups covered = strip.both(rows, rows.coveredBegin, rows.coveredEnd, origin);
            coverGoingOn<shape>(piece, row, cursor, all, piece.joins ? all.held(covered.first, covered.end) : Groups{},
                                strip.either(rows, rows.deeperBegin, rows.deeperEnd, origin), between);
        }
    } else if (piece.withStart) {
        piece.moves ? coverMoving<shape, true>(piece, row, cursor, all, between, piece.levelTop)
                    : cover<shape, true, false, Top::level>(piece, row, cursor, all.end, piece.levelTop);
    } else {
        piece.moves ? coverMoving<shape, false>(piece, row, cursor, all, between, piece.levelTop)
                    : coverEnd<shape>(piece, row, cursor, all.end, piece.levelTop);
    }
}

template <Shape shape>
BURIN_INLINE void coverRows(const Upright& piece, const Rows& rows, Intervals intervals) noexcept {
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const RowSpans& one = intervals[i];
        const bool two =
            width > lanes && (one.v & 1) == 0 && i + 1 < intervals.size() && intervals[i + 1].v == one.v + 1;
        coverStrip<shape>(piece, rows, {one, two ? intervals[++i] : one});
    }
}

BURIN_INLINE void coverAny(Shape shape, const Upright& piece, const Rows& rows, Intervals intervals) noexcept {
    switch (shape) {
    case Shape::ball:
        return coverRows<Shape::ball>(piece, rows, intervals);
    case Shape::flat:
        return coverRows<Shape::flat>(piece, rows, intervals);
    case Shape::bullNose:
        return coverRows<Shape::bullNose>(piece, rows, intervals);
    }
}
