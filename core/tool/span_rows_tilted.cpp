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

/// Heights of eight lines, units from an end's base; low > high where there is none.
struct Heights {
    Floats low = floats(nowhere), high = floats(-nowhere);
};

/// A linear number along one row.
struct RowLinear {
    float origin, x;
    BURIN_INLINE RowLinear(const Linear& number, double y, float more = 0.0F) noexcept
        : origin(static_cast<float>(number.origin + number.y * y) + more), x(static_cast<float>(number.x)) {}
    BURIN_INLINE Floats at(Floats place) const noexcept { return origin + x * place; }
};

struct RowSlab {
    RowLinear middle;
    float half;
    BURIN_INLINE RowSlab(const TiltedPiece::Slab& slab, double y, float more = 0.0F) noexcept
        : middle(slab.middle, y, more), half(slab.half) {}
};

struct RowCylinder {
    RowLinear aside, middle;
    RowSlab slab;
    float radius, stretch;
    BURIN_INLINE RowCylinder(const TiltedPiece::Cylinder& cylinder, double y, float more = 0.0F) noexcept
        : aside(cylinder.aside, y)
        , middle(cylinder.middle, y, more)
        , slab(cylinder.slab, y, more)
        , radius(cylinder.radius)
        , stretch(cylinder.stretch) {}

    /// Eight lines that meet it.
    struct Met {
        Heights heights;
        Floats inside;           ///< square voxels of half chord across the axis; none of it where not above 0
        Floats place, slabPlace; ///< of the axis and of the slab's middle
    };
    BURIN_INLINE Met at(Floats x) const noexcept {
        const Floats off = aside.at(x);
        Met met;
        met.inside = (radius - off) * (radius + off);
        met.place = middle.at(x);
        met.slabPlace = slab.middle.at(x);
        const Floats half = stretch * rootsOf(met.inside);
        met.heights.low = most(met.place - half, met.slabPlace - slab.half);
        met.heights.high = least(met.place + half, met.slabPlace + slab.half);
        return met;
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
template <Rounding rounding>
struct RowPiece {
    const TiltedPiece& piece;
    RowCylinder standing;
    RowSlab hemisphere;
    float y;       ///< voxels, from the rounding's middle
    float middleZ; ///< units, of the rounding's middle from the end's base, + 1/2
    // As in the piece: what a loop stores could be any of it, for all that the compiler knows.
    float middleX, squareRadius, perStretch, rimAlong, rimReach;

    BURIN_INLINE RowPiece(const TiltedPiece& itsPiece, const End& end, std::int32_t v) noexcept
        : piece(itsPiece)
        , standing(itsPiece.standing, v - end.y, end.middle)
        , hemisphere(itsPiece.hemisphere, v - end.y, end.middle)
        , y(static_cast<float>(v - end.y - itsPiece.middleY))
        , middleZ(itsPiece.middleZ + end.middle)
        , middleX(itsPiece.middleX)
        , squareRadius(itsPiece.radius * itsPiece.radius)
        , perStretch(itsPiece.perStretch)
        , rimAlong(itsPiece.rimAlong)
        , rimReach(itsPiece.rimReach) {}

    /// @param rims lines that a rim passes on the way
    BURIN_INLINE Heights at(Floats fromTip, Integers& rims) const noexcept {
        const RowCylinder::Met met = standing.at(fromTip);
        rims = rimsAt(met);
        const Integers meets = (met.inside > Floats{}) & (met.heights.low < met.heights.high);
        Heights all{meets ? met.heights.low : floats(nowhere), meets ? met.heights.high : floats(-nowhere)};
        if constexpr (rounding == Rounding::ball) addHemisphere(fromTip, all);
        return all;
    }
    /// An end in the corner that a bull nose's rounding takes off lies below its circle and out from it.
    BURIN_INLINE Integers offRounding(Floats x, Floats z) const noexcept {
        const Floats along = x * piece.axisX + y * piece.axisY + z * piece.axisZ;
        const Floats across = x * x + y * y + z * z - along * along;
        return (along < Floats{}) & (across > piece.flatRadius * piece.flatRadius);
    }

private:
    /// Where a line meets the plane of a face, its distance² from the axis is radius² by little more or less.
    BURIN_INLINE Integers rimsAt(const RowCylinder::Met& met) const noexcept {
        const Floats along = (met.slabPlace - met.place) * perStretch;
        if constexpr (rounding == Rounding::none) { // the same of both faces, which lie as far from the middle
            const Floats even = met.inside - rimAlong * rimAlong - along * along;
            return magnitudes(magnitudes(even) - magnitudes((2.0F * rimAlong) * along)) < rimReach;
        }
        const Floats upper = along + rimAlong;
        return magnitudes(met.inside - upper * upper) < rimReach;
    }
    BURIN_INLINE void addHemisphere(Floats fromTip, Heights& all) const noexcept {
        const Floats x = fromTip - middleX;
        const Floats inside = squareRadius - (x * x + y * y);
        const Floats half = unitsAVoxel * rootsOf(inside), place = hemisphere.middle.at(fromTip);
        const Floats low = most(middleZ - half, place - hemisphere.half);
        const Floats high = least(middleZ + half, place + hemisphere.half);
        const Integers meets = (inside > Floats{}) & (low < high);
        all.low = meets ? least(all.low, low) : all.low;
        all.high = meets ? most(all.high, high) : all.high;
    }
};

/// Heights of some groups of a row.
struct Part {
    static constexpr std::int32_t mostGroups = 64; ///< which one word tells
    EightFloats low[mostGroups], high[mostGroups];
};

/// Groups of a part, a bit each.
struct Marked {
    std::uint64_t rims = 0;                ///< that a rim passes on the way
    std::uint64_t offLow = 0, offHigh = 0; ///< with ends that a bull nose's rounding takes off
};

/// Ends in the corners that the rounding of a bull nose takes off, moved on to it; `count` groups at a time, the last
/// one with itself.
template <std::size_t count>
BURIN_INLINE void takeCorners(const RowPiece<Rounding::bullNose>& row, Floats firstU, float side, std::uint64_t groups,
                              Part& part) noexcept {
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

template <Rounding rounding>
BURIN_INLINE void coverGroup(const RowPiece<rounding>& row, Floats u, std::int32_t place, Part& part,
                             Marked& marked) noexcept {
    Integers rims;
    const Heights all = row.at(u, rims);
    store(all.low, part.low[place]);
    store(all.high, part.high[place]);
    marked.rims |= std::uint64_t{anyOf(rims)} << place;
    if constexpr (rounding == Rounding::bullNose) {
        const Integers meets = all.low < all.high;
        const Floats x = u - row.middleX;
        const Floats low = (all.low - row.middleZ) / unitsAVoxel, high = (all.high - row.middleZ) / unitsAVoxel;
        marked.offLow |= std::uint64_t{anyOf(meets & row.offRounding(x, low))} << place;
        marked.offHigh |= std::uint64_t{anyOf(meets & row.offRounding(x, high))} << place;
    }
}

template <Rounding rounding>
BURIN_INLINE void coverCorners(const RowPiece<rounding>& row, Floats firstU, const Marked& marked,
                               Part& part) noexcept {
    if constexpr (rounding == Rounding::bullNose) {
        takeCorners<2>(row, firstU, 1.0F, marked.offLow, part);
        takeCorners<2>(row, firstU, -1.0F, marked.offHigh, part);
    }
}

/// What lies between the ends of the way: the wall that a rim leaves, seen from the start.
struct RowRim {
    RowCylinder wall;
    RowLinear lift;
    float scale;
    bool present;
    BURIN_INLINE RowRim(const TiltedPiece::Rim& rim, const End& from, std::int32_t v) noexcept
        : wall(rim.wall, v - from.y)
        , lift(rim.lift, v - from.y, from.middle)
        , scale(rim.scale)
        , present(rim.wall.present) {}

    BURIN_INLINE void add(Floats fromTip, Heights& all) const noexcept {
        if (!present) return;
        const RowCylinder::Met met = wall.at(fromTip);
        const Integers meets = (met.inside > Floats{}) & (met.heights.low < met.heights.high);
        const Floats level = lift.at(fromTip);
        all.low = meets ? least(all.low, level + scale * met.heights.low) : all.low;
        all.high = meets ? most(all.high, level + scale * met.heights.high) : all.high;
    }
};

BURIN_INLINE Floats linesFrom(const End& end, std::int32_t group) noexcept {
    return floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + (group * lanes - end.wholeX)) - end.partX;
}

/// Where the spans of a part of a row go.
struct Kept {
    EightIntegers *low, *high;
    Integers base, lineEnd;
    BURIN_INLINE Kept(const TiltedPiece& piece, const End& end, const RowSpans& stretch, std::int32_t first) noexcept
        : low(stretch.low + first)
        , high(stretch.high + first)
        , base(integers(end.base))
        , lineEnd(integers(piece.lineEnd)) {}
    BURIN_INLINE void keep(const Heights& all, std::int32_t group) const noexcept {
        store(most(wholeOf(all.low) + base, Integers{}), low[group]);
        store(least(wholeOf(all.high) + base, lineEnd), high[group]);
    }
    BURIN_INLINE void add(const Heights& all, std::int32_t group) const noexcept {
        store(most(least(load(low[group]), wholeOf(all.low) + base), Integers{}), low[group]);
        store(least(most(load(high[group]), wholeOf(all.high) + base), lineEnd), high[group]);
    }
};

/// What the piece covers at the end of its way.
/// @return groups that a rim passes on the way
template <Rounding rounding>
BURIN_INLINE std::uint64_t coverEnd(const TiltedPiece& piece, const RowSpans& stretch, std::int32_t first,
                                    std::int32_t count, Part& part) noexcept {
    const RowPiece<rounding> row(piece, piece.to, stretch.v);
    const Floats firstU = linesFrom(piece.to, stretch.firstGroup + first);
    const Kept kept(piece, piece.to, stretch, first);
    Marked marked;
    Floats u = firstU;
    if constexpr (rounding == Rounding::bullNose) {
        for (std::int32_t i = 0; i < count; ++i, u += lanes) coverGroup(row, u, i, part, marked);
        coverCorners(row, firstU, marked, part);
        for (std::int32_t i = 0; i < count; ++i) kept.keep({load(part.low[i]), load(part.high[i])}, i);
    } else {
        for (std::int32_t i = 0; i < count; ++i, u += lanes) {
            Integers rims;
            kept.keep(row.at(u, rims), i);
            marked.rims |= std::uint64_t{anyOf(rims)} << i;
        }
    }
    return marked.rims;
}

/// Adds what it covers at the start, and the walls of its rims between, to some groups.
template <Rounding rounding>
BURIN_INLINE void addWay(const TiltedPiece& piece, const RowSpans& stretch, std::int32_t first, std::uint64_t groups,
                         Part& part) noexcept {
    const RowPiece<rounding> row(piece, piece.from, stretch.v);
    const RowRim lower(piece.rims[0], piece.from, stretch.v), upper(piece.rims[1], piece.from, stretch.v);
    const Floats firstU = linesFrom(piece.from, stretch.firstGroup + first);
    const Kept kept(piece, piece.from, stretch, first);
    Marked marked;
    for (std::uint64_t rest = groups; rest != 0; rest &= rest - 1) {
        const std::int32_t i = std::countr_zero(rest);
        coverGroup(row, firstU + static_cast<float>(i * lanes), i, part, marked);
    }
    coverCorners(row, firstU, marked, part);
    for (; groups != 0; groups &= groups - 1) {
        const std::int32_t i = std::countr_zero(groups);
        Heights all{load(part.low[i]), load(part.high[i])};
        const Floats u = firstU + static_cast<float>(i * lanes);
        lower.add(u, all);
        upper.add(u, all);
        kept.add(all, i);
    }
}

template <Rounding rounding>
BURIN_INLINE void coverRow(const TiltedPiece& piece, const RowSpans& stretch) noexcept {
    const std::uint64_t always = piece.withStart || piece.rimsEverywhere ? ~std::uint64_t{0} : 0;
    Part part;
    for (std::int32_t first = 0; first < stretch.groups; first += Part::mostGroups) {
        const std::int32_t count = std::min(stretch.groups - first, Part::mostGroups);
        const std::uint64_t rims = coverEnd<rounding>(piece, stretch, first, count, part) | always;
        const std::uint64_t groups = rims & ~std::uint64_t{0} >> (Part::mostGroups - count);
        if (piece.moves && groups != 0) addWay<rounding>(piece, stretch, first, groups, part);
    }
}

} // namespace

BURIN_VECTORISED void tiltedBall(const TiltedPiece& piece, Stretches stretches) noexcept {
    for (const RowSpans& stretch : stretches) coverRow<Rounding::ball>(piece, stretch);
}

BURIN_VECTORISED void tiltedFlat(const TiltedPiece& piece, Stretches stretches) noexcept {
    for (const RowSpans& stretch : stretches) coverRow<Rounding::none>(piece, stretch);
}

BURIN_VECTORISED void tiltedBullNose(const TiltedPiece& piece, Stretches stretches) noexcept {
    for (const RowSpans& stretch : stretches) coverRow<Rounding::bullNose>(piece, stretch);
}

} // namespace burin::kernels
