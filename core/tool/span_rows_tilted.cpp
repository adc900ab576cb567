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

/// Heights of eight lines, units from a tip; low > high where there is none.
struct Heights {
    Floats low = floats(nowhere), high = floats(-nowhere);
};

/// A linear number along one row.
struct RowLinear {
    float origin, x;
    BURIN_INLINE RowLinear(const Linear& number, double y) noexcept
        : origin(static_cast<float>(number.origin + number.y * y)), x(static_cast<float>(number.x)) {}
    BURIN_INLINE Floats at(Floats place) const noexcept { return origin + x * place; }
};

struct RowSlab {
    RowLinear middle;
    float half;
    BURIN_INLINE RowSlab(const TiltedPiece::Slab& slab, double y) noexcept : middle(slab.middle, y), half(slab.half) {}
};

struct RowCylinder {
    RowLinear aside, middle;
    RowSlab slab;
    float radius, stretch;
    BURIN_INLINE RowCylinder(const TiltedPiece::Cylinder& cylinder, double y) noexcept
        : aside(cylinder.aside, y)
        , middle(cylinder.middle, y)
        , slab(cylinder.slab, y)
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

/// One end of a line's stretch within a bull nose's outline, moved on to the rounding. The rounding is what balls about
/// the places of a circle fill: each step takes the ball that lies out from the axis in the direction of the place
/// before it. No step leaves the piece, and as the circle is smooth, what a step is short of goes with the square of
/// what its direction is off.
/// @param z    voxels from the rounding's middle @param side 1: lower end, -1: upper end
/// @param outs lines whose end lies off the rounding; loses those that miss it
BURIN_INLINE Floats reachRounding(const TiltedPiece& piece, Floats x, float y, Floats z, float side,
                                  Integers& outs) noexcept {
    const Floats flatSquare = x * x + y * y, flatAlong = x * piece.axisX + y * piece.axisY;
    const Floats square = floats(piece.cornerRadius * piece.cornerRadius), tiny = floats(1e-12F);
    if (piece.nearlyLevel) z = atHeightOf(piece, flatSquare, flatAlong, z, side);
    Integers meets = outs;
    for (int step = 0; step < mostSteps; ++step) {
        const Floats along = flatAlong + z * piece.axisZ;
        const Floats share = piece.flatRadius / rootsOf(most(flatSquare + z * z - along * along, tiny));
        const Floats aside = x - share * (x - along * piece.axisX), beside = y - share * (y - along * piece.axisY);
        const Floats inside = square - (aside * aside + beside * beside);
        const Floats next = share * (z - along * piece.axisZ) - side * rootsOf(inside);
        const Floats moved = next - z;
        meets = outs & (inside > Floats{});
        z = outs ? next : z;
        const Floats still = meets ? floats(nearEnough) : floats(nearlyStill);
        if (bitsOf(outs & ((moved > still) | (moved < -still))) == 0) break;
    }
    outs = meets;
    return z;
}

/// What the piece covers where it stands.
template <Rounding rounding>
struct RowPiece {
    const TiltedPiece& piece;
    RowCylinder standing;
    RowSlab hemisphere;
    float y; ///< of the rounding's middle

    BURIN_INLINE RowPiece(const TiltedPiece& itsPiece, double fromTip) noexcept
        : piece(itsPiece)
        , standing(itsPiece.standing, fromTip)
        , hemisphere(itsPiece.hemisphere, fromTip)
        , y(static_cast<float>(fromTip - itsPiece.middleY)) {}

    /// @param rims lines that a rim passes on the way
    BURIN_INLINE Heights at(Floats fromTip, Integers& rims) const noexcept {
        const RowCylinder::Met met = standing.at(fromTip);
        rims = rimAt(met, piece.rimHeights[1]);
        if constexpr (rounding == Rounding::none) rims = rims | rimAt(met, piece.rimHeights[0]);
        Heights all = met.heights;
        Integers meets = (met.inside > Floats{}) & (all.low < all.high);
        if constexpr (rounding == Rounding::bullNose) addRounding(fromTip, all, meets);
        all.low = meets ? all.low : floats(nowhere);
        all.high = meets ? all.high : floats(-nowhere);
        if constexpr (rounding == Rounding::ball) addHemisphere(fromTip, all);
        return all;
    }

private:
    /// Where a line meets the plane of a face, its distance² from the axis is radius² by little more or less.
    BURIN_INLINE Integers rimAt(const RowCylinder::Met& met, float height) const noexcept {
        const Floats along = (met.slabPlace + height - met.place) * piece.perStretch;
        const Floats beyond = met.inside - along * along;
        return (beyond < piece.rimReach) & (beyond > -piece.rimReach);
    }
    BURIN_INLINE void addHemisphere(Floats fromTip, Heights& all) const noexcept {
        const Floats x = fromTip - piece.middleX;
        const Floats inside = piece.radius * piece.radius - (x * x + y * y);
        const Floats half = unitsAVoxel * rootsOf(inside), place = hemisphere.middle.at(fromTip);
        const Floats low = most(piece.middleZ - half, place - hemisphere.half);
        const Floats high = least(piece.middleZ + half, place + hemisphere.half);
        const Integers meets = (inside > Floats{}) & (low < high);
        all.low = meets ? least(all.low, low) : all.low;
        all.high = meets ? most(all.high, high) : all.high;
    }
    /// An end in the corner that the rounding takes off lies below its circle and out from it.
    BURIN_INLINE Integers offRounding(Floats x, Floats z) const noexcept {
        const Floats along = x * piece.axisX + y * piece.axisY + z * piece.axisZ;
        const Floats across = x * x + y * y + z * z - along * along;
        return (along < Floats{}) & (across > piece.flatRadius * piece.flatRadius);
    }
    BURIN_INLINE void addRounding(Floats fromTip, Heights& all, Integers& meets) const noexcept {
        const Floats x = fromTip - piece.middleX;
        const Floats low = (all.low - piece.middleZ) / unitsAVoxel, high = (all.high - piece.middleZ) / unitsAVoxel;
        const Integers offLow = meets & offRounding(x, low), offHigh = meets & offRounding(x, high);
        if (bitsOf(offLow) != 0) {
            Integers met = offLow;
            const Floats reached = reachRounding(piece, x, y, offLow ? low : Floats{}, 1.0F, met);
            all.low = met ? most(all.low, reached * unitsAVoxel + piece.middleZ) : all.low;
            meets = meets & (met | ~offLow);
        }
        if (bitsOf(offHigh) != 0) {
            Integers met = offHigh;
            const Floats reached = reachRounding(piece, x, y, offHigh ? high : Floats{}, -1.0F, met);
            all.high = met ? least(all.high, reached * unitsAVoxel + piece.middleZ) : all.high;
            meets = meets & (met | ~offHigh);
        }
        meets = meets & (all.low < all.high);
    }
};

BURIN_INLINE void addRounded(const Heights& heights, const End& end, Integers& low, Integers& high) noexcept {
    const Integers valid = heights.low <= heights.high;
    const Floats zero{};
    low = valid ? least(low, wholeOf((valid ? heights.low : zero) + end.middle) + end.base) : low;
    high = valid ? most(high, wholeOf((valid ? heights.high : zero) + end.middle) + end.base) : high;
}

/// What lies between the ends of the way: the wall that a rim leaves, seen from the start.
struct RowRim {
    RowCylinder wall;
    RowLinear lift;
    float scale;
    bool present;
    BURIN_INLINE RowRim(const TiltedPiece::Rim& rim, double fromTip) noexcept
        : wall(rim.wall, fromTip), lift(rim.lift, fromTip), scale(rim.scale), present(rim.wall.present) {}

    BURIN_INLINE void add(Floats fromTip, const End& from, Integers& low, Integers& high) const noexcept {
        if (!present) return;
        const RowCylinder::Met met = wall.at(fromTip);
        const Integers meets = (met.inside > Floats{}) & (met.heights.low < met.heights.high);
        const Floats level = lift.at(fromTip);
        const Heights heights{meets ? level + scale * met.heights.low : floats(nowhere),
                              meets ? level + scale * met.heights.high : floats(-nowhere)};
        addRounded(heights, from, low, high);
    }
};

BURIN_INLINE Floats linesFrom(const End& end, std::int32_t group) noexcept {
    return floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + (group * lanes - end.wholeX)) - end.partX;
}

template <Rounding rounding>
BURIN_INLINE void coverRow(const TiltedPiece& piece, const Stretch& stretch) noexcept {
    constexpr std::int32_t most64 = 64; // groups whose rims one word tells
    const RowPiece<rounding> end(piece, stretch.v - piece.to.y), start(piece, stretch.v - piece.from.y);
    const RowRim lower(piece.rims[0], stretch.v - piece.from.y), upper(piece.rims[1], stretch.v - piece.from.y);
    const std::uint64_t always = stretch.moves && (stretch.withStart || piece.rimsEverywhere) ? ~std::uint64_t{0} : 0;
    for (std::int32_t first = 0; first < stretch.groups; first += most64) {
        const std::int32_t count = std::min(stretch.groups - first, most64);
        std::uint64_t passed = 0;
        Floats toU = linesFrom(piece.to, stretch.firstGroup + first);
        for (std::int32_t i = 0; i < count; ++i, toU += lanes) {
            Integers low = integers(SpanRows::none), high = integers(-SpanRows::none), near;
            addRounded(end.at(toU, near), piece.to, low, high);
            passed |= std::uint64_t{bitsOf(near) != 0} << i;
            store(most(low, Integers{}), stretch.low[first + i]);
            store(least(high, integers(piece.lineEnd)), stretch.high[first + i]);
        }
        if (!stretch.moves) continue;
        passed = (passed | always) & ~std::uint64_t{0} >> (most64 - count);
        for (; passed != 0; passed &= passed - 1) {
            const std::int32_t group = first + std::countr_zero(passed);
            Integers low = load(stretch.low[group]), high = load(stretch.high[group]), near;
            const Floats fromU = linesFrom(piece.from, stretch.firstGroup + group);
            addRounded(start.at(fromU, near), piece.from, low, high);
            lower.add(fromU, piece.from, low, high);
            upper.add(fromU, piece.from, low, high);
            store(most(low, Integers{}), stretch.low[group]);
            store(least(high, integers(piece.lineEnd)), stretch.high[group]);
        }
    }
}

} // namespace

BURIN_VECTORISED void tiltedBall(const TiltedPiece& piece, const Stretch& stretch) noexcept {
    coverRow<Rounding::ball>(piece, stretch);
}

BURIN_VECTORISED void tiltedFlat(const TiltedPiece& piece, const Stretch& stretch) noexcept {
    coverRow<Rounding::none>(piece, stretch);
}

BURIN_VECTORISED void tiltedBullNose(const TiltedPiece& piece, const Stretch& stretch) noexcept {
    coverRow<Rounding::bullNose>(piece, stretch);
}

} // namespace burin::kernels
