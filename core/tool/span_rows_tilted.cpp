// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"

#include <algorithm>
#include <bit>

namespace burin::kernels {

namespace {

using Linear = TiltedPiece::Linear;
using End = TiltedPiece::End;
using Rounding = TiltedPiece::Rounding;

// Of the search for a bull nose's rounding: it ends once no line's end moves by more than this in a step, and none that
// has not met the rounding yet by more than that, which but for axes that are nearly level takes three or four steps.
constexpr float nearEnough = 1.0F / 256.0F, nearlyStill = 1.0F / 16384.0F; // voxels
constexpr int mostSteps = 64;

/// Heights of eight lines, units from an end's base; low >= high where there is none.
struct Heights {
    Floats low = floats(nowhere), high = floats(-nowhere);
    BURIN_INLINE void include(const Heights& more) noexcept {
        const Integers meets = more.low < more.high;
        low = meets ? least(low, more.low) : low;
        high = meets ? most(high, more.high) : high;
    }
};

/// A row as an end of the way sees it.
struct RowFrame {
    double y = 0.0;     ///< voxels from the tip
    double partX = 0.0; ///< of the tip's x, beyond its whole part
    BURIN_INLINE RowFrame(const End& end, std::int32_t v) noexcept : y(v - end.y), partX(end.x - end.wholeX) {}
};

/// A linear number along one row, of lines a whole number of voxels from an end's whole part.
struct RowLinear {
    float origin, x;
    BURIN_INLINE RowLinear(const Linear& number, const RowFrame& row, float more = 0.0F) noexcept
        : origin(static_cast<float>(number.origin + number.y * row.y - number.x * row.partX) + more)
        , x(static_cast<float>(number.x)) {}
    BURIN_INLINE Floats at(Floats place) const noexcept { return origin + x * place; }
};

struct RowCylinder {
    RowLinear aside, middle, floor;
    float radius, stretch, thickness;
    BURIN_INLINE RowCylinder(const TiltedPiece::Cylinder& cylinder, const RowFrame& row, float more = 0.0F) noexcept
        : aside(cylinder.aside, row)
        , middle(cylinder.middle, row, more)
        , floor(cylinder.floor, row, more)
        , radius(cylinder.radius)
        , stretch(cylinder.stretch)
        , thickness(cylinder.thickness) {}

    /// Where eight lines meet it without its planes.
    BURIN_INLINE Heights unheld(Floats x) const noexcept {
        const Floats off = aside.at(x), inside = (radius - off) * (radius + off);
        const Floats place = middle.at(x), half = stretch * rootsOf(inside);
        return {place - half, place + half};
    }
    BURIN_INLINE Heights at(Floats x) const noexcept {
        const Heights all = unheld(x);
        const Floats low = floor.at(x);
        return {most(all.low, low), least(all.high, low + thickness)};
    }
};

/// Of an axis that is nearly level: the place on the line where the piece is as wide as at the height of another one.
BURIN_INLINE Floats atHeightOf(const TiltedPiece& piece, Floats flatSquare, Floats flatAlong, Floats z,
                               float side) noexcept {
    const Floats along = least(flatAlong + z * piece.axisZ, Floats{});
    const Floats wide = piece.flatRadius + rootsOf(piece.cornerRadius * piece.cornerRadius - along * along);
    const float perSquare = 1.0F / (1.0F - piece.axisZ * piece.axisZ);
    const Floats middle = flatAlong * (piece.axisZ * perSquare);
    return middle - side * rootsOf(middle * middle - (flatSquare - flatAlong * flatAlong - wide * wide) * perSquare);
}

/// Ends of some lines' stretches within a bull nose's outline, eight lines at a time, of one row.
template <std::size_t count>
struct CornerEnds {
    Floats x[count];      ///< voxels from the rounding's middle
    Floats z[count];      ///< the same; the ends
    Integers outs[count]; ///< lines whose end lies off the rounding
};

/// Moves ends on to the rounding. That is what balls about the places of a circle fill: each step takes the ball that
/// lies out from the axis in the direction of the place before it. No step leaves the piece, and as the circle is
/// smooth, what a step is short of goes with the square of what its direction is off.
/// Several at a time: a step is a chain of roots and a division, in which others find room.
/// @param side 1: lower ends, -1: upper ends @param ends `outs` loses the lines that miss the rounding
template <std::size_t count>
BURIN_INLINE void reachRounding(const TiltedPiece& piece, float y, float side, CornerEnds<count>& ends) noexcept {
    const Floats square = floats(piece.cornerRadius * piece.cornerRadius), tiny = floats(1e-12F);
    Floats flatSquare[count], flatAlong[count];
    Integers meets[count];
    for (std::size_t i = 0; i < count; ++i) {
        flatSquare[i] = ends.x[i] * ends.x[i] + y * y;
        flatAlong[i] = ends.x[i] * piece.axisX + y * piece.axisY;
        if (piece.nearlyLevel) ends.z[i] = atHeightOf(piece, flatSquare[i], flatAlong[i], ends.z[i], side);
    }
    for (int step = 0; step < mostSteps; ++step) {
        Integers moves = integers(0);
        for (std::size_t i = 0; i < count; ++i) {
            const Floats x = ends.x[i], z = ends.z[i];
            const Floats along = flatAlong[i] + z * piece.axisZ;
            const Floats share = piece.flatRadius / rootsOf(most(flatSquare[i] + z * z - along * along, tiny));
            const Floats aside = x - share * (x - along * piece.axisX), beside = y - share * (y - along * piece.axisY);
            const Floats inside = square - (aside * aside + beside * beside);
            const Floats next = share * (z - along * piece.axisZ) - side * rootsOf(inside), moved = next - z;
            meets[i] = inside > Floats{};
            ends.z[i] = ends.outs[i] ? next : z;
            const Floats still = meets[i] ? floats(nearEnough) : floats(nearlyStill);
            moves = moves | (ends.outs[i] & ((moved > still) | (moved < -still)));
        }
        if (!anyOf(moves)) break;
    }
    for (std::size_t i = 0; i < count; ++i) ends.outs[i] = ends.outs[i] & meets[i];
}

/// What the piece covers where it stands, in units from an end's base, + 1/2. Of a bull nose without its rounding.
template <Rounding rounding, bool rises>
struct RowPiece {
    const TiltedPiece& piece;
    RowCylinder standing;
    RowLinear equator, face;
    float y;       ///< voxels, from the rounding's middle
    float middleZ; ///< units, of the rounding's middle from the end's base, + 1/2
    float middleX; ///< voxels, of the rounding's middle
    float square;  ///< square voxels, of a ball in this row

    BURIN_INLINE RowPiece(const TiltedPiece& itsPiece, const End& end, std::int32_t v) noexcept
        : RowPiece(itsPiece, end, RowFrame(end, v)) {}
    BURIN_INLINE RowPiece(const TiltedPiece& itsPiece, const End& end, const RowFrame& row) noexcept
        : piece(itsPiece)
        , standing(itsPiece.standing, row, end.middle)
        , equator(itsPiece.equator, row, end.middle)
        , face(itsPiece.face, row, end.middle)
        , y(static_cast<float>(row.y - itsPiece.middleY))
        , middleZ(itsPiece.middleZ + end.middle)
        , middleX(static_cast<float>(row.partX + itsPiece.middleX))
        , square((itsPiece.radius - y) * (itsPiece.radius + y)) {}

    BURIN_INLINE Heights at(Floats x) const noexcept {
        if constexpr (rounding == Rounding::ball)
            return ballAt(x);
        else
            return standing.at(x);
    }
    /// An end in the corner that a bull nose's rounding takes off lies below its circle and out from it.
    BURIN_INLINE Integers offRounding(Floats x, Floats z) const noexcept {
        const Floats along = x * piece.axisX + y * piece.axisY + z * piece.axisZ;
        const Floats across = x * x + y * y + z * z - along * along;
        return (along < Floats{}) & (across > piece.flatRadius * piece.flatRadius);
    }

private:
    /// A ball goes over into its straight part at the equator's plane: each end lies on the side that it would have
    /// there.
    BURIN_INLINE Heights ballAt(Floats x) const noexcept {
        const Heights straight = standing.unheld(x);
        const Floats off = x - middleX, half = unitsAVoxel * rootsOf(square - off * off), border = equator.at(x);
        const Floats end = face.at(x), roundLow = middleZ - half, roundHigh = middleZ + half;
        if constexpr (rises)
            return {straight.low < border ? roundLow : straight.low,
                    least(straight.high < border ? roundHigh : straight.high, end)};
        else
            return {most(straight.low > border ? roundLow : straight.low, end),
                    straight.high > border ? roundHigh : straight.high};
    }
};

/// Heights of some groups of a row.
struct Part {
    static constexpr std::int32_t mostGroups = 64; ///< which one word tells
    EightFloats low[mostGroups], high[mostGroups];
};

/// Ends in the corners that the rounding of a bull nose takes off, moved on to it; `count` groups at a time, the last
/// one with itself.
template <std::size_t count>
BURIN_INLINE void takeCorners(const RowPiece<Rounding::bullNose, true>& row, Floats firstU, float side,
                              std::uint64_t groups, Part& part) noexcept {
    while (groups != 0) {
        CornerEnds<count> ends;
        std::int32_t places[count];
        Integers offs[count];
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t place = places[i] = std::countr_zero(groups);
            if (i == count - 1 || (groups & (groups - 1)) != 0) groups &= groups - 1;
            const Floats low = load(part.low[place]), high = load(part.high[place]);
            const Floats z = ((side > 0.0F ? low : high) - row.middleZ) / unitsAVoxel;
            ends.x[i] = firstU + static_cast<float>(place * lanes) - row.middleX;
            ends.outs[i] = offs[i] = (low < high) & row.offRounding(ends.x[i], z);
            ends.z[i] = ends.outs[i] ? z : Floats{};
        }
        reachRounding(row.piece, row.y, side, ends);
        for (std::size_t i = 0; i < count; ++i) {
            Floats low = load(part.low[places[i]]), high = load(part.high[places[i]]);
            const Floats reached = ends.z[i] * unitsAVoxel + row.middleZ;
            if (side > 0.0F)
                low = ends.outs[i] ? most(low, reached) : low;
            else
                high = ends.outs[i] ? least(high, reached) : high;
            const Integers none = (offs[i] & ~ends.outs[i]) | (low >= high);
            store(none ? floats(nowhere) : low, part.low[places[i]]);
            store(none ? floats(-nowhere) : high, part.high[places[i]]);
        }
    }
}

/// What a bull nose covers, of some groups.
BURIN_INLINE void coverPart(const RowPiece<Rounding::bullNose, true>& row, Floats firstU, std::int32_t count,
                            Part& part) noexcept {
    std::uint64_t offLow = 0, offHigh = 0; // a bit a group, with ends that the rounding takes off
    Floats u = firstU;
    for (std::int32_t i = 0; i < count; ++i, u += lanes) {
        const Heights all = row.at(u);
        store(all.low, part.low[i]);
        store(all.high, part.high[i]);
        const Integers meets = all.low < all.high;
        const Floats x = u - row.middleX;
        const Floats low = (all.low - row.middleZ) / unitsAVoxel, high = (all.high - row.middleZ) / unitsAVoxel;
        offLow |= std::uint64_t{anyOf(meets & row.offRounding(x, low))} << i;
        offHigh |= std::uint64_t{anyOf(meets & row.offRounding(x, high))} << i;
    }
    takeCorners<2>(row, firstU, 1.0F, offLow, part);
    takeCorners<2>(row, firstU, -1.0F, offHigh, part);
}

/// Groups of a row, and where their spans go.
struct Groups {
    std::int32_t begin = 0, end = 0; ///< counted from the stretch's first
};

/// Calls `take(heights, places, group)` for what the piece covers of some groups where it stands.
template <Rounding rounding, bool rises, class Take>
BURIN_INLINE void forEachGroup(const RowPiece<rounding, rises>& row, Floats firstU, Groups groups,
                               const Take& take) noexcept {
    if constexpr (rounding == Rounding::bullNose) {
        Part part;
        for (; groups.begin < groups.end; groups.begin += Part::mostGroups) {
            const std::int32_t count = std::min(groups.end - groups.begin, Part::mostGroups);
            Floats u = firstU + static_cast<float>(groups.begin * lanes);
            coverPart(row, u, count, part);
            for (std::int32_t i = 0; i < count; ++i, u += lanes)
                take({load(part.low[i]), load(part.high[i])}, u, groups.begin + i);
        }
    } else {
        Floats u = firstU + static_cast<float>(groups.begin * lanes);
        for (std::int32_t i = groups.begin; i < groups.end; ++i, u += lanes) take(row.at(u), u, i);
    }
}

/// What lies between the ends of the way: the wall that a rim leaves, seen from the start.
struct RowRim {
    RowCylinder wall;
    RowLinear lift;
    float scale;
    BURIN_INLINE RowRim(const TiltedPiece::Rim& rim, const End& from, std::int32_t v) noexcept
        : RowRim(rim, from, RowFrame(from, v)) {}
    BURIN_INLINE RowRim(const TiltedPiece::Rim& rim, const End& from, const RowFrame& row) noexcept
        : wall(rim.wall, row), lift(rim.lift, row, from.middle), scale(rim.scale) {}

    BURIN_INLINE Heights at(Floats x) const noexcept {
        const Heights met = wall.at(x);
        const Floats level = lift.at(x);
        return {level + scale * met.low, level + scale * met.high};
    }
};

/// Places of a stretch's first group: lines from an end's whole part, which are whole numbers, so that what is found of
/// a line does not depend on where its stretch begins.
BURIN_INLINE Floats linesFrom(const End& end, const RowSpans& stretch) noexcept {
    return floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + (stretch.firstGroup * lanes - end.wholeX));
}

/// Where the spans of a row go.
struct Kept {
    EightIntegers *low, *high;
    Integers base, lineEnd;
    BURIN_INLINE Kept(const TiltedPiece& piece, const End& end, const RowSpans& stretch) noexcept
        : low(stretch.low), high(stretch.high), base(integers(end.base)), lineEnd(integers(piece.lineEnd)) {}
};

/// Keeps what the piece covers at the end of its way.
struct KeepEnd : Kept {
    using Kept::Kept;
    BURIN_INLINE void operator()(const Heights& all, Floats, std::int32_t group) const noexcept {
        // What the lines' ends leave of it does not tell whether there was any.
        store(most(wholeOf(all.low < all.high ? all.low : floats(nowhere)) + base, Integers{}), low[group]);
        store(least(wholeOf(all.high) + base, lineEnd), high[group]);
    }
};

/// Adds what it covers at the start, and the walls that rims leave from there.
template <std::size_t count>
struct AddWay : Kept {
    const std::array<RowRim, count>& walls;
    BURIN_INLINE AddWay(const TiltedPiece& piece, const RowSpans& stretch,
                        const std::array<RowRim, count>& itsWalls) noexcept
        : Kept(piece, piece.from, stretch), walls(itsWalls) {}
    BURIN_INLINE void operator()(const Heights& start, Floats u, std::int32_t group) const noexcept {
        Heights all;
        all.include(start);
        for (std::size_t i = 0; i < count; ++i) all.include(walls[i].at(u));
        const Integers oldLow = load(low[group]), oldHigh = load(high[group]),
                       none = oldLow > integers(SpanRows::none / 2);
        const Integers newLow = wholeOf(all.low) + base, newHigh = wholeOf(all.high) + base;
        store(most(none ? newLow : least(oldLow, newLow), Integers{}), low[group]);
        store(least(none ? newHigh : most(oldHigh, newHigh), lineEnd), high[group]);
    }
};

/// What the piece covers at the end of its way.
template <Rounding rounding, bool rises>
BURIN_INLINE void coverEnd(const TiltedPiece& piece, const RowSpans& stretch) noexcept {
    const RowPiece<rounding, rises> row(piece, piece.to, stretch.v);
    forEachGroup(row, linesFrom(piece.to, stretch), {0, stretch.groups}, KeepEnd(piece, piece.to, stretch));
}

/// What it covers at the start and on the way, everywhere.
template <Rounding rounding, bool rises>
BURIN_INLINE void addWay(const TiltedPiece& piece, const RowSpans& stretch) noexcept {
    const RowPiece<rounding, rises> row(piece, piece.from, stretch.v);
    const Floats lines = linesFrom(piece.from, stretch);
    const RowRim upper(piece.rims[1], piece.from, stretch.v);
    if constexpr (rounding == Rounding::none) {
        const std::array walls{RowRim(piece.rims[0], piece.from, stretch.v), upper};
        forEachGroup(row, lines, {0, stretch.groups}, AddWay(piece, stretch, walls));
    } else {
        forEachGroup(row, lines, {0, stretch.groups}, AddWay(piece, stretch, std::array{upper}));
    }
}

/// The same where rims pass.
template <Rounding rounding, bool rises>
BURIN_INLINE void addRims(const TiltedPiece& piece, const TiltedRows& rows, const RowSpans& stretch) noexcept {
    const RowPiece<rounding, rises> row(piece, piece.from, stretch.v);
    const Floats lines = linesFrom(piece.from, stretch);
    const std::int32_t lane = stretch.v - rows.first;
    for (std::size_t i = rounding == Rounding::none ? 0 : 1; i < 2; ++i) {
        const TiltedRows::RimGroups& groups = rows.rims[i];
        const auto held = [&](const EightIntegers& group) {
            return std::clamp(group[lane] - stretch.firstGroup, 0, stretch.groups);
        };
        const std::array walls{RowRim(piece.rims[i], piece.from, stretch.v)};
        const AddWay add(piece, stretch, walls);
        for (const Groups& part : {Groups{held(groups.outerBegin), held(groups.innerBegin)},
                                   Groups{held(groups.innerEnd), held(groups.outerEnd)}})
            forEachGroup(row, lines, part, add);
    }
}

template <Rounding rounding, bool rises>
BURIN_INLINE void coverRow(const TiltedPiece& piece, const TiltedRows& rows, const RowSpans& stretch) noexcept {
    coverEnd<rounding, rises>(piece, stretch);
    if (!piece.moves) return;
    if (piece.withStart || piece.rimsEverywhere)
        addWay<rounding, rises>(piece, stretch);
    else
        addRims<rounding, rises>(piece, rows, stretch);
}

} // namespace

BURIN_VECTORISED void tiltedBall(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept {
    if (piece.rises)
        for (const RowSpans& stretch : stretches) coverRow<Rounding::ball, true>(piece, rows, stretch);
    else
        for (const RowSpans& stretch : stretches) coverRow<Rounding::ball, false>(piece, rows, stretch);
}

BURIN_VECTORISED void tiltedFlat(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept {
    for (const RowSpans& stretch : stretches) coverRow<Rounding::none, true>(piece, rows, stretch);
}

BURIN_VECTORISED void tiltedBullNose(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept {
    for (const RowSpans& stretch : stretches) coverRow<Rounding::bullNose, true>(piece, rows, stretch);
}

} // namespace burin::kernels
