// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace {

using Shape = SpanRows::Shape;
using Upright = SpanRows::Upright;
using End = SpanRows::End;

constexpr int cornerSteps = 10;

/// Height of the rounding below its middle, voxels, over lines `inside` away from the outline (square: R² - r²).
template <Shape shape>
BURIN_INLINE Floats drop(const Upright& piece, Floats inside) noexcept {
    if constexpr (shape == Shape::ball) return rootsOf(inside);
    // (corner - over)(corner + over), over = r - flat; corner - over = R - r without cancellation.
    const Floats radius = rootsOf(piece.radius * piece.radius - inside);
    const Floats over = most(radius - piece.flatRadius, Floats{});
    const Floats left = least(inside / (piece.radius + radius), floats(piece.cornerRadius));
    return rootsOf(left * (piece.cornerRadius + over));
}

/// Lower face at one end of the way, units over the rounding's middle there. `inside`: R² - r².
template <Shape shape>
BURIN_INLINE Floats lowAtEnd(const Upright& piece, const End& end, Floats inside) noexcept {
    const Integers covered = inside > Floats{};
    if constexpr (shape == Shape::flat) return covered ? floats(end.flatHeight) : floats(nowhere);
    Floats height = -unitsAVoxel * drop<shape>(piece, inside);
    if constexpr (shape == Shape::bullNose) {
        const Floats flatInside = floats(piece.radius * piece.radius - piece.flatRadius * piece.flatRadius);
        height = inside >= flatInside ? floats(end.flatHeight) : height;
    }
    return covered ? height : floats(nowhere);
}

/// A line seen from the way: `ahead` along it from the start, `chord` half of the way on which the piece covers it.
struct FromWay {
    Floats ahead, chord, asideSquare;
    Integers meets; ///< all bits or none
};

/// Offset from axis to line at which a bull nose that rises is lowest over it, between two bounds: the zero of a
/// function that grows, by false position, each second step a halving.
BURIN_INLINE Floats cornerOffset(const Upright& piece, Floats asideSquare, Floats low, Floats high) noexcept {
    const Floats rise = floats(piece.rise < 0.0F ? -piece.sine : piece.sine);
    // Over the flat middle it does not fall.
    const Floats flatEdge = rootsOf(piece.flatRadius * piece.flatRadius - asideSquare);
    low = least(most(low, flatEdge), high);
    const auto excess = [&](Floats offset) __attribute__((always_inline)) {
        const Floats radius = rootsOf(asideSquare + offset * offset);
        const Floats over = least(most(radius - piece.flatRadius, Floats{}), floats(piece.cornerRadius));
        const Floats below = rootsOf((piece.cornerRadius - over) * (piece.cornerRadius + over));
        const Floats grown = piece.cosine * over * offset - rise * below * radius;
        return over > Floats{} ? grown : floats(-piece.cornerRadius);
    };
    Floats atLow = excess(low), atHigh = excess(high);
    const Integers lowBest = atLow >= Floats{}, highBest = atHigh <= Floats{};
    const Floats first = low, last = high;
    for (int step = 0; step < cornerSteps; ++step) {
        const Floats bend = atHigh - atLow;
        const Floats part = step % 2 == 0 ? least(most(-atLow / bend, Floats{}), floats(1.0F)) : floats(0.5F);
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

/// Lower face between the ends, units over the rounding's middle at the end.
template <Shape shape>
BURIN_INLINE Floats lowBetween(const Upright& piece, const FromWay& line) noexcept {
    const Floats zero{}, one = floats(1.0F);
    if constexpr (shape == Shape::ball) {
        const Floats part = (line.ahead - piece.sine * line.chord) * piece.perReach;
        const Integers valid = line.meets & (part > zero) & (part < one);
        return valid ? piece.rise * (part - one) - (unitsAVoxel * piece.cosine) * line.chord : floats(nowhere);
    }
    const Integers passes = (line.ahead > zero) & (line.ahead < floats(piece.reach));
    if constexpr (shape == Shape::flat) {
        const Floats part = (line.ahead - piece.riseSign * line.chord) * piece.perReach;
        const Integers valid = line.meets & (passes | ((part > zero) & (part < one)));
        return valid ? piece.to.flatHeight + piece.rise * (least(most(part, zero), one) - one) : floats(nowhere);
    }
    Floats offset = zero;
    const Floats first = most(line.ahead - piece.reach, -line.chord), last = least(line.ahead, line.chord);
    if (piece.rise > 0.0F)
        offset = cornerOffset(piece, line.asideSquare, most(first, zero), last);
    else if (piece.rise < 0.0F)
        offset = -cornerOffset(piece, line.asideSquare, most(-last, zero), -first);
    offset = least(most(offset, first), last);
    const Floats part = (line.ahead - offset) * piece.perReach;
    const Integers valid = line.meets & (first <= last) & (passes | ((part > zero) & (part < one)));
    const Floats inside = piece.radius * piece.radius - line.asideSquare - offset * offset;
    const Floats height = piece.rise * (least(most(part, zero), one) - one) - unitsAVoxel * drop<shape>(piece, inside);
    return valid ? height : floats(nowhere);
}

/// Upper face between the ends, units; it is flat.
BURIN_INLINE Integers highBetween(const Upright& piece, const FromWay& line) noexcept {
    const Floats zero{}, one = floats(1.0F);
    const Floats part = (line.ahead + piece.riseSign * line.chord) * piece.perReach;
    const Integers passes = (line.ahead > zero) & (line.ahead < floats(piece.reach));
    const Integers valid = line.meets & (passes | ((part > zero) & (part < one)));
    const Floats height = piece.rise * (least(most(part, zero), one) - one);
    return valid ? wholeOf(piece.topMiddle + height) + piece.topBase : integers(-SpanRows::none);
}

/// What depends on the row alone.
struct Row {
    float fromSquare, toSquare;     ///< R² - y² at both ends, voxels²
    float ahead, aside, wayX, wayY; ///< of the line at x = 0, seen from the start
};

/// Groups of a stretch, counted from its first.
struct Groups {
    std::int32_t first = 0, end = 0;
};

/// The upper face is at one height wherever the lower one is, or both its heights count.
enum class Top : bool { level, rises };

/// Where lines lie from one end of the way, in lanes; what a loop over groups keeps in registers.
struct Place {
    Floats u, part; ///< whole lines from the end; its part of a voxel
    BURIN_INLINE static Place of(const End& end, const Stretch& stretch, std::int32_t group) noexcept {
        const Integers first = Integers{0, 1, 2, 3, 4, 5, 6, 7} + (stretch.firstGroup + group) * lanes;
        return {floatsOf(first - end.wholeX), floats(end.partX)};
    }
};

/// Lines that the piece covers at the end of the way, and no lower between: all but `high` follows from the end.
template <Shape shape>
BURIN_INLINE void coverEnd(const Upright& piece, const Row& row, const Stretch& stretch, Groups groups,
                           std::int32_t top) noexcept {
    Place to = Place::of(piece.to, stretch, groups.first);
    const Floats square = floats(row.toSquare), middle = floats(piece.to.middle);
    const Integers base = integers(piece.to.base), high = integers(top < piece.lineEnd ? top : piece.lineEnd);
    const Upright shapeOnly = piece;
    const End end = piece.to;
    EightIntegers *low = stretch.low + groups.first, *const last = stretch.low + groups.end;
    EightIntegers* highs = stretch.high + groups.first;
    for (; low < last; ++low, ++highs, to.u += lanes) {
        const Floats x = to.u - to.part;
        const Floats height = lowAtEnd<shape>(shapeOnly, end, square - x * x);
        store(most(wholeOf(height + middle) + base, Integers{}), *low);
        store(high, *highs);
    }
}

/// Lines behind the axis of a piece that rises: only its upper face moves there.
BURIN_INLINE void coverTop(const Upright& piece, const Stretch& stretch, Groups groups) noexcept {
    const Integers low = integers(piece.from.top > 0 ? piece.from.top : 0);
    const Integers high = integers(piece.to.top < piece.lineEnd ? piece.to.top : piece.lineEnd);
    for (std::int32_t group = groups.first; group < groups.end; ++group) {
        store(low, stretch.low[group]);
        store(high, stretch.high[group]);
    }
}

template <Shape shape, bool withStart, bool moves, Top top>
BURIN_INLINE void cover(const Upright& piece, const Row& row, const Stretch& stretch, Groups groups,
                        std::int32_t levelTop) noexcept {
    Place to = Place::of(piece.to, stretch, groups.first), from = Place::of(piece.from, stretch, groups.first);
    for (std::int32_t group = groups.first; group < groups.end; ++group, to.u += lanes, from.u += lanes) {
        const Floats toX = to.u - to.part, fromX = from.u - from.part;
        const Floats toInside = row.toSquare - toX * toX, fromInside = row.fromSquare - fromX * fromX;
        FromWay line{};
        Floats height = lowAtEnd<shape>(piece, piece.to, toInside);
        if constexpr (moves) {
            const Floats aside = row.aside - fromX * row.wayY;
            const Floats inside = (piece.radius - aside) * (piece.radius + aside);
            line = {fromX * row.wayX + row.ahead, rootsOf(inside), aside * aside, inside > Floats{}};
            height = least(height, lowBetween<shape>(piece, line));
        }
        Integers low = wholeOf(height + piece.to.middle) + piece.to.base;
        Integers high = integers(levelTop);
        if constexpr (withStart) {
            const Floats start = lowAtEnd<shape>(piece, piece.from, fromInside);
            low = least(low, wholeOf(start + piece.from.middle) + piece.from.base);
        }
        if constexpr (top == Top::rises) {
            high = toInside > Floats{} ? integers(piece.to.top) : integers(-SpanRows::none);
            // No higher than at the ends, roundings or not: lines that are covered there agree on it.
            if constexpr (moves) high = most(high, least(highBetween(piece, line), integers(piece.highestTop)));
            // What was left behind at the start joins on to what is beyond it.
            const Integers started = fromInside > Floats{};
            low = started ? least(low, integers(piece.from.top)) : low;
            high = started ? most(high, integers(piece.from.top)) : high;
        }
        store(most(low, Integers{}), stretch.low[group]);
        store(least(high, integers(piece.lineEnd)), stretch.high[group]);
    }
}

/// Groups between which a ball can be lowest on the way, not at an end: between its axis at the start and at the end,
/// as far as a sloping way shifts that.
BURIN_INLINE Groups groupsBetween(const Upright& piece, const Row& row, const Stretch& stretch, Groups all) noexcept {
    constexpr float slack = 1.0F; // voxels
    const float shift = piece.sine * piece.radius;
    const float low = (shift < 0.0F ? shift : 0.0F) - slack, high = piece.reach + (shift > 0.0F ? shift : 0.0F) + slack;
    if (row.wayX < 1e-3F && row.wayX > -1e-3F) {
        constexpr float across = 1e-3F * 4096.0F; // lines of a row differ by no more
        return row.ahead + across < low || row.ahead - across > high ? Groups{all.end, all.end} : all;
    }
    const float one = (low - row.ahead) / row.wayX, other = (high - row.ahead) / row.wayX;
    const auto origin = static_cast<float>(piece.from.wholeX - stretch.firstGroup * lanes);
    const float start = (one < other ? one : other) + origin, stop = (one < other ? other : one) + origin;
    Groups between = all;
    if (start > 8.0F * static_cast<float>(all.first))
        between.first = start < 8.0F * static_cast<float>(all.end) ? static_cast<std::int32_t>(start) / lanes : all.end;
    if (stop < 8.0F * static_cast<float>(all.end))
        between.end = stop < 0.0F ? between.first : static_cast<std::int32_t>(stop) / lanes + 1;
    if (between.end < between.first) between.end = between.first;
    return between;
}

/// Groups of which the piece covers every line at both ends of the way, roundings aside.
BURIN_INLINE Groups groupsCovered(const Upright& piece, const Row& row, const Stretch& stretch) noexcept {
    constexpr double slack = 1.0 / 16.0; // voxels
    if (!(row.fromSquare > 0.0F) || !(row.toSquare > 0.0F)) return {};
    const double fromHalf = __builtin_sqrt(static_cast<double>(row.fromSquare)) - slack;
    const double toHalf = __builtin_sqrt(static_cast<double>(row.toSquare)) - slack;
    const double origin = static_cast<double>(stretch.firstGroup) * lanes;
    const double fromX = piece.from.x - origin, toX = piece.to.x - origin;
    const double low = fromX - fromHalf > toX - toHalf ? fromX - fromHalf : toX - toHalf;
    const double high = fromX + fromHalf < toX + toHalf ? fromX + fromHalf : toX + toHalf;
    // Lines low … high, whole ones; the stretch begins at or before them.
    Groups covered{low > 0.0 ? (static_cast<std::int32_t>(low) + lanes) / lanes : 0,
                   high > 0.0 ? (static_cast<std::int32_t>(high) + 1) / lanes : 0};
    if (covered.end > stretch.groups) covered.end = stretch.groups;
    return covered.first < covered.end ? covered : Groups{};
}

/// A piece that moves below an upper face at one height.
template <Shape shape, bool withStart>
BURIN_INLINE void coverMoving(const Upright& piece, const Row& row, const Stretch& stretch, Groups groups,
                              std::int32_t top) noexcept {
    Groups between = groups;
    if constexpr (shape == Shape::ball && !withStart) {
        between = groupsBetween(piece, row, stretch, groups);
        coverEnd<shape>(piece, row, stretch, {groups.first, between.first}, top);
        coverEnd<shape>(piece, row, stretch, {between.end, groups.end}, top);
    }
    cover<shape, withStart, true, Top::level>(piece, row, stretch, between, top);
}

/// A piece that goes on from where it was, its upper face at two heights within the stock. On lines that it covers all
/// the way that face counts with the higher one; where it rises, nothing else is new behind its axis.
template <Shape shape>
BURIN_INLINE void coverGoingOn(const Upright& piece, const Row& row, const Stretch& stretch) noexcept {
    Groups covered = groupsCovered(piece, row, stretch);
    if (!piece.joins) covered = {};
    const auto held = [&](std::int32_t group) {
        return group < covered.first ? covered.first : group < covered.end ? group : covered.end;
    };
    const Groups front{held(stretch.firstDeeper), held(stretch.endDeeper)};
    cover<shape, false, true, Top::rises>(piece, row, stretch, {0, covered.first}, 0);
    coverTop(piece, stretch, {covered.first, front.first});
    coverMoving<shape, false>(piece, row, stretch, front, piece.highestTop);
    coverTop(piece, stretch, {front.end, covered.end});
    cover<shape, false, true, Top::rises>(piece, row, stretch, {covered.end, stretch.groups}, 0);
}

template <Shape shape>
BURIN_INLINE void choose(const Upright& piece, const Row& row, const Stretch& stretch) noexcept {
    const Groups all{0, stretch.groups};
    if (piece.topRises) {
        if (stretch.withStart)
            stretch.moves ? cover<shape, true, true, Top::rises>(piece, row, stretch, all, 0)
                          : cover<shape, true, false, Top::rises>(piece, row, stretch, all, 0);
        else
            stretch.moves ? coverGoingOn<shape>(piece, row, stretch)
                          : cover<shape, false, false, Top::rises>(piece, row, stretch, all, 0);
    } else if (stretch.withStart) {
        stretch.moves ? coverMoving<shape, true>(piece, row, stretch, all, piece.levelTop)
                      : cover<shape, true, false, Top::level>(piece, row, stretch, all, piece.levelTop);
    } else {
        stretch.moves ? coverMoving<shape, false>(piece, row, stretch, all, piece.levelTop)
                      : coverEnd<shape>(piece, row, stretch, all, piece.levelTop);
    }
}

template <Shape shape>
BURIN_INLINE void coverRow(const Upright& piece, const Stretch& stretch) noexcept {
    const double radius = piece.radius;
    const double fromY = stretch.v - piece.from.y, toY = stretch.v - piece.to.y;
    const Row row{static_cast<float>((radius - fromY) * (radius + fromY)),
                  static_cast<float>((radius - toY) * (radius + toY)),
                  static_cast<float>(fromY * piece.wayY),
                  static_cast<float>(fromY * piece.wayX),
                  static_cast<float>(piece.wayX),
                  static_cast<float>(piece.wayY)};
    choose<shape>(piece, row, stretch);
}

} // namespace

BURIN_VECTORISED void uprightBall(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::ball>(piece, stretch);
}

BURIN_VECTORISED void uprightFlat(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::flat>(piece, stretch);
}

BURIN_VECTORISED void uprightBullNose(const SpanRows::Upright& piece, const Stretch& stretch) noexcept {
    coverRow<Shape::bullNose>(piece, stretch);
}

} // namespace burin::kernels
