// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0

// Part of span_rows_upright.cpp, which includes it once for each register width (core/base/whole_registers.h): a lane
// is a row of lines.

constexpr float far = 1e6F; // voxels, beyond every line
// Lines that are left out lie at least this far behind those that can get more, so that rounding can't affect any.
constexpr float clipMargin = 1.0F; // voxels

/// Returns numbers rounded down to integers.
BURIN_INLINE Integers floorsOf(Floats numbers) noexcept {
    const Integers whole = wholeOf(numbers);
    return whole + (floatsOf(whole) > numbers); // a true comparison is -1
}

/// Positions along u, in voxels from a line at a group boundary.
struct Across {
    std::int32_t group = 0;       ///< of that line
    float from = 0.0F, to = 0.0F; ///< ends of the move
    BURIN_INLINE Integers groupsOf(Integers lines) const noexcept { return (lines >> 3) + group; }
};

struct Extent {
    Floats low, high;
    BURIN_INLINE void include(Floats x, Integers where) noexcept {
        low = where ? least(low, x) : low;
        high = where ? most(high, x) : high;
    }
    BURIN_INLINE void includeCircle(float middle, Floats square) noexcept {
        const Floats half = rootsOf(square);
        include(middle - half, square > Floats{});
        include(middle + half, square > Floats{});
    }
};

/// Returns the interval of each row that the swept disc meets.
BURIN_INLINE Extent extentOf(const Upright& piece, const Across& across, Floats fromY, Floats fromSquare,
                             Floats toSquare) noexcept {
    Extent extent{each(far), each(-far)};
    extent.includeCircle(across.to, toSquare);
    if (piece.withStart || piece.moves) extent.includeCircle(across.from, fromSquare);
    const float rise = piece.reach * piece.wayY; // component of the move across the rows
    if (!piece.moves || rise == 0.0F) return extent;
    const float perRise = 1.0F / rise;
    // The two straight sides between the circles, where a row meets them.
    for (const float side : {-piece.radius, piece.radius}) {
        const Floats part = (fromY - side * piece.wayX) * perRise;
        extent.include(across.from - side * piece.wayY + part * (piece.reach * piece.wayX),
                       (part >= Floats{}) & (part <= each(1.0F)));
    }
    return extent;
}

/// Finds the first and last line of each row that can be lower than at the start of the move. The height of the piece
/// over a line is convex along the move: if it does not decrease at the start, it never does. It decreases where the
/// move leads to the outside of the lower face: for a ball where ahead > slope * height of the centre over the face, so
/// that the lines of a row end at an ellipse; for a flat face that does not sink, ahead of the axis.
BURIN_INLINE void findDeeper(const Upright& piece, const Across& across, Floats ahead, Floats fromSquare,
                             Extent& deeper) noexcept {
    deeper.low = each(-far);
    deeper.high = each(far);
    if (!piece.clipsLow) return;
    // With x in the direction of the move: fall(x) = x * along + past - slope * root(square - x^2).
    const float along = piece.wayX < 0.0F ? -piece.wayX : piece.wayX, slope = piece.slope;
    const float steep = along * along + slope * slope, size = __builtin_sqrtf(steep);
    const Floats zero{}, past = ahead + clipMargin, square = most(fromSquare, zero), half = rootsOf(fromSquare);
    const Floats last = past + half * along;
    const float sinking = slope < 0.0F ? size : 0.0F;
    if (size * (piece.radius + piece.reach) < clipMargin) { // all lines of a row nearly alike
        deeper.low = last + clipMargin + half * sinking < zero ? each(far) : each(-far);
        return;
    }
    const Floats middle = past * (-along / steep);
    const Floats apart = rootsOf(square * steep - past * past) * (slope / steep);
    const Integers none = (last <= zero) & (past + half * sinking <= zero);
    const Floats low = past - half * along > zero ? each(-far) : middle + apart;
    const Floats high = last > zero ? each(far) : middle - apart;
    deeper.low = none ? each(far) : across.from + (piece.wayX < 0.0F ? -high : low);
    deeper.high = none ? each(far) : across.from + (piece.wayX < 0.0F ? -low : high);
}

/// Returns the positions of a row between two distances ahead of the move's start.
BURIN_INLINE Extent placesAhead(const Upright& piece, const Across& across, Floats ahead, Floats low,
                                Floats high) noexcept {
    constexpr float slack = 0.5F; // voxels, for rounding errors
    const float perWay = 1.0F / piece.wayX;
    const Floats one = (low - slack - ahead) * perWay, other = (high + slack - ahead) * perWay;
    Extent places;
    places.low = most(least(one, other) + across.from, each(-far));
    places.high = least(most(one, other) + across.from, each(far));
    return places;
}

/// Returns the positions between which a ball can be lowest between the ends of the move: on a line, the ball is lowest
/// where the line lies ahead by the sine of the move's slope times its half chord. The bounds of the half chord over
/// the positions found so far give tighter positions.
BURIN_INLINE Extent betweenOf(const Upright& piece, const Across& across, Floats ahead, Floats aside) noexcept {
    const Floats radius = each(piece.radius);
    if (piece.wayX < 1e-3F && piece.wayX > -1e-3F) {
        constexpr float apart = 1e-3F * 4096.0F + 1.0F; // lines of a row differ by no more
        const float shift = piece.sine * piece.radius;
        const float low = shift < 0.0F ? shift : 0.0F, high = piece.reach + (shift > 0.0F ? shift : 0.0F);
        const Integers none = (ahead + apart < each(low)) | (ahead - apart > each(high));
        return {each(-far), none ? each(-far) : each(far)};
    }
    Floats leastChord{}, mostChord = radius;
    Extent between;
    for (int closer = 0; closer < 2; ++closer) {
        const Floats low = piece.sine * (piece.sine < 0.0F ? mostChord : leastChord);
        const Floats high = piece.sine * (piece.sine < 0.0F ? leastChord : mostChord) + piece.reach;
        between = placesAhead(piece, across, ahead, low, high);
        const Floats one = aside - (between.low - across.from) * piece.wayY;
        const Floats other = aside - (between.high - across.from) * piece.wayY;
        const Floats oneSquare = one * one, otherSquare = other * other;
        leastChord = rootsOf(radius * radius - most(oneSquare, otherSquare));
        mostChord =
            (one < Floats{}) == (other < Floats{}) ? rootsOf(radius * radius - least(oneSquare, otherSquare)) : radius;
    }
    return between;
}

/// Returns the positions that the disc covers at both ends of the move, with a margin for rounding errors.
BURIN_INLINE Extent coveredOf(const Across& across, Floats fromSquare, Floats toSquare) noexcept {
    constexpr float slack = 1.0F / 16.0F; // voxels
    const Floats fromHalf = rootsOf(fromSquare) - slack, toHalf = rootsOf(toSquare) - slack;
    Extent covered;
    covered.low = most(across.from - fromHalf, across.to - toHalf);
    covered.high = least(across.from + fromHalf, across.to + toHalf);
    return covered;
}

BURIN_INLINE void keep(const Across& across, Integers firstLine, Integers endLine, std::int32_t* begin,
                       std::int32_t* end) noexcept {
    const Integers first = across.groupsOf(firstLine), last = across.groupsOf(endLine);
    storeAt(first, begin);
    storeAt(most(first, last), end);
}

/// @param at index of the first of the rows, as many as a register holds
BURIN_INLINE void planSome(const Upright& piece, Rows& rows, std::size_t at) noexcept {
    const Integers v = numbers() + (rows.first + static_cast<std::int32_t>(at));
    const Floats fromY = floatsOf(v - piece.from.wholeY) - piece.from.partY;
    const Floats toY = floatsOf(v - piece.to.wholeY) - piece.to.partY;
    const Floats fromSquare = (piece.radius - fromY) * (piece.radius + fromY);
    const Floats toSquare = (piece.radius - toY) * (piece.radius + toY);
    const Floats ahead = fromY * piece.wayY;
    storeAt(fromSquare, &rows.fromSquare[at]);
    storeAt(toSquare, &rows.toSquare[at]);
    storeAt(ahead, &rows.ahead[at]);
    storeAt(fromY * piece.wayX, &rows.aside[at]);
    const std::int32_t origin = piece.to.wholeX & ~7;
    const Across across{origin >> 3, static_cast<float>(piece.from.wholeX - origin) + piece.from.partX,
                        static_cast<float>(piece.to.wholeX - origin) + piece.to.partX};

    Extent met = extentOf(piece, across, fromY, fromSquare, toSquare), deeper;
    findDeeper(piece, across, ahead, fromSquare, deeper);
    const Integers deeperFirst = floorsOf(deeper.low), deeperEnd = floorsOf(deeper.high) + 2;
    Integers first = floorsOf(met.low), end = floorsOf(met.high) + 2;
    keep(across, deeperFirst, deeperEnd + 7, &rows.deeperBegin[at], &rows.deeperEnd[at]);
    if (piece.clips) {
        first = most(first, deeperFirst);
        end = least(end, deeperEnd);
    }
    keep(across, first, (end > first) ? end + 7 : first, &rows.begin[at], &rows.end[at]);
    const Extent between = betweenOf(piece, across, ahead, fromY * piece.wayX);
    keep(across, floorsOf(between.low), floorsOf(between.high) + 8, &rows.betweenBegin[at], &rows.betweenEnd[at]);
    if (!piece.topRises) return; // not used otherwise
    const Extent covered = coveredOf(across, fromSquare, toSquare);
    keep(across, floorsOf(covered.low) + 8, floorsOf(covered.high) + 1, &rows.coveredBegin[at], &rows.coveredEnd[at]);
}

BURIN_INLINE void planAll(const Upright& piece, std::int32_t firstRow, Rows& rows) noexcept {
    rows.first = firstRow;
    for (std::size_t at = 0; at < Rows::count; at += width) planSome(piece, rows, at);
}
