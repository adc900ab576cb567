// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace {

using Linear = TiltedPiece::Linear;
using End = TiltedPiece::End;
using Rounding = TiltedPiece::Rounding;

constexpr int roundingSteps = 6;

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
    BURIN_INLINE void narrow(Floats x, Heights& heights) const noexcept {
        const Floats place = middle.at(x);
        heights.low = most(heights.low, place - half);
        heights.high = least(heights.high, place + half);
    }
};

struct RowCylinder {
    RowLinear aside, middle;
    RowSlab slab;
    float radius, stretch;
    bool present;
    BURIN_INLINE RowCylinder(const TiltedPiece::Cylinder& cylinder, double y) noexcept
        : aside(cylinder.aside, y)
        , middle(cylinder.middle, y)
        , slab(cylinder.slab, y)
        , radius(cylinder.radius)
        , stretch(cylinder.stretch)
        , present(cylinder.present) {}
    /// Without the slab; the result says which lines meet it.
    BURIN_INLINE Integers infinite(Floats x, Heights& heights) const noexcept {
        const Floats off = aside.at(x), inside = (radius - off) * (radius + off);
        const Floats place = middle.at(x), half = stretch * rootsOf(inside);
        heights.low = place - half;
        heights.high = place + half;
        return inside > Floats{};
    }
    BURIN_INLINE void add(Floats x, Heights& all) const noexcept {
        if (!present) return;
        Heights own;
        const Integers meets = infinite(x, own);
        slab.narrow(x, own);
        const Integers valid = meets & (own.low < own.high);
        all.low = valid ? least(all.low, own.low) : all.low;
        all.high = valid ? most(all.high, own.high) : all.high;
    }
};

/// From a place outside of a bull nose (but within its outline) along the line to its surface: Newton's steps on the
/// distance from what the rounding is rolled over, which is convex, so that no step goes too far.
/// @param z voxels from the rounding's middle. @return place; `meets` loses the lines that miss.
BURIN_INLINE Floats reachRounding(const TiltedPiece& piece, Floats x, float y, Floats z, float sign,
                                  Integers& meets) noexcept {
    const Floats flatSquare = x * x + y * y, flatAlong = x * piece.axisX + y * piece.axisY;
    const Floats tiny = floats(1e-6F);
    for (int step = 0; step < roundingSteps; ++step) {
        const Floats along = flatAlong + z * piece.axisZ;
        const Floats radius = rootsOf(flatSquare + z * z - along * along);
        const Floats over = most(radius - piece.flatRadius, Floats{}), under = least(along, Floats{});
        const Floats distance = rootsOf(over * over + under * under);
        const Floats excess = distance - piece.cornerRadius;
        const Floats outward = (z - along * piece.axisZ) / most(radius, tiny);
        const Floats slope = sign * (under * piece.axisZ + over * outward) / most(distance, tiny);
        const Integers outside = excess > floats(1e-5F);
        const Integers nears = slope < floats(-1e-4F);
        meets = meets & ~(outside & ~nears);
        const Floats length = outside & nears ? -excess / slope : Floats{};
        z += sign * length;
        if (bitsOf(outside & meets) == 0) break;
    }
    return z;
}

/// What the piece covers at one end of its way.
template <Rounding rounding>
struct RowEnd {
    const TiltedPiece& piece;
    RowCylinder standing;
    RowSlab hemisphere;
    float y; ///< of the rounding's middle

    BURIN_INLINE RowEnd(const TiltedPiece& itsPiece, double fromTip) noexcept
        : piece(itsPiece)
        , standing(itsPiece.standing, fromTip)
        , hemisphere(itsPiece.hemisphere, fromTip)
        , y(static_cast<float>(fromTip - itsPiece.middleYExact)) {}

    BURIN_INLINE Heights at(Floats fromTip) const noexcept {
        Heights all;
        if constexpr (rounding == Rounding::bullNose) {
            Integers meets = standing.infinite(fromTip, all);
            standing.slab.narrow(fromTip, all);
            meets = meets & (all.low < all.high);
            if (bitsOf(meets) != 0) {
                const Floats x = fromTip - piece.middleX;
                const Floats low = (all.low - piece.middleZ) / unitsAVoxel,
                             high = (all.high - piece.middleZ) / unitsAVoxel;
                Integers met = meets;
                const Floats reachedLow = reachRounding(piece, x, y, meets ? low : Floats{}, 1.0F, met);
                const Floats reachedHigh = reachRounding(piece, x, y, meets ? high : Floats{}, -1.0F, met);
                meets = met;
                all.low = reachedLow > low ? reachedLow * unitsAVoxel + piece.middleZ : all.low;
                all.high = reachedHigh < high ? reachedHigh * unitsAVoxel + piece.middleZ : all.high;
                meets = meets & (all.low < all.high);
            }
            all.low = meets ? all.low : floats(nowhere);
            all.high = meets ? all.high : floats(-nowhere);
            return all;
        }
        standing.add(fromTip, all);
        if constexpr (rounding == Rounding::ball) {
            const Floats x = fromTip - piece.middleX;
            const Floats inside = piece.radius * piece.radius - (x * x + y * y);
            const Floats half = unitsAVoxel * rootsOf(inside);
            Heights own{piece.middleZ - half, piece.middleZ + half};
            hemisphere.narrow(fromTip, own);
            const Integers meets = (inside > Floats{}) & (own.low < own.high);
            all.low = meets ? least(all.low, own.low) : all.low;
            all.high = meets ? most(all.high, own.high) : all.high;
        }
        return all;
    }
};

/// What it covers between the ends, seen from the start.
template <Rounding rounding>
struct RowWay {
    const TiltedPiece& piece;
    std::array<RowCylinder, 2> faces;
    std::array<RowSlab, 3> box;
    float ahead, aside, wayX, wayY; ///< of a ball's middle
    float y;

    BURIN_INLINE RowWay(const TiltedPiece& itsPiece, double fromTip) noexcept
        : piece(itsPiece)
        , faces{RowCylinder(itsPiece.faces[0], fromTip), RowCylinder(itsPiece.faces[1], fromTip)}
        , box{RowSlab(itsPiece.box[0], fromTip), RowSlab(itsPiece.box[1], fromTip), RowSlab(itsPiece.box[2], fromTip)}
        , ahead(static_cast<float>((fromTip - itsPiece.middleYExact) * itsPiece.wayY))
        , aside(static_cast<float>((fromTip - itsPiece.middleYExact) * itsPiece.wayX))
        , wayX(static_cast<float>(itsPiece.wayX))
        , wayY(static_cast<float>(itsPiece.wayY))
        , y(static_cast<float>(fromTip)) {}

    BURIN_INLINE Heights at(Floats fromTip) const noexcept {
        Heights all;
        if constexpr (rounding != Rounding::ball) faces[0].add(fromTip, all);
        faces[1].add(fromTip, all);
        if (piece.hasBox) {
            Heights own{floats(-nowhere), floats(nowhere)};
            for (const RowSlab& slab : box) slab.narrow(fromTip, own);
            const Integers valid = own.low < own.high;
            all.low = valid ? least(all.low, own.low) : all.low;
            all.high = valid ? most(all.high, own.high) : all.high;
        }
        if constexpr (rounding == Rounding::ball) {
            if (!piece.hasCapsule) return all;
            const Floats x = fromTip - piece.middleX, off = aside - x * wayY;
            const Floats inside = (piece.radius - off) * (piece.radius + off), chord = rootsOf(inside);
            const Floats along = x * wayX + ahead, zero{}, one = floats(1.0F);
            const Floats first = (along - piece.sine * chord) * piece.perReach;
            const Floats last = (along + piece.sine * chord) * piece.perReach;
            const Floats half = (unitsAVoxel * piece.cosine) * chord;
            const Floats low = piece.rise * first - half + piece.middleZ,
                         high = piece.rise * last + half + piece.middleZ;
            const Integers meets = inside > zero;
            // Only what the ball's own half touches: beyond its flat side is the straight part, or nothing.
            const Floats side = fromTip * piece.axisX + y * piece.axisY - piece.hemisphereTop;
            const Floats rise = floats(piece.axisZ / unitsAVoxel);
            const Integers lows =
                meets & (first > zero) & (first < one) & (side + rise * low <= piece.axialWay * first);
            const Integers highs = meets & (last > zero) & (last < one) & (side + rise * high <= piece.axialWay * last);
            // Either is a place of the solid, so that it counts for both ends of the span.
            all.low = lows ? least(all.low, low) : all.low;
            all.high = lows ? most(all.high, low) : all.high;
            all.low = highs ? least(all.low, high) : all.low;
            all.high = highs ? most(all.high, high) : all.high;
        }
        return all;
    }
};

BURIN_INLINE void addRounded(const Heights& heights, const End& end, Integers& low, Integers& high) noexcept {
    const Integers valid = heights.low <= heights.high;
    const Floats zero{};
    low = valid ? least(low, wholeOf((valid ? heights.low : zero) + end.middle) + end.base) : low;
    high = valid ? most(high, wholeOf((valid ? heights.high : zero) + end.middle) + end.base) : high;
}

template <Rounding rounding>
BURIN_INLINE void coverRow(const TiltedPiece& piece, const Stretch& stretch) noexcept {
    const RowEnd<rounding> end(piece, stretch.v - piece.to.y), start(piece, stretch.v - piece.from.y);
    const RowWay<rounding> way(piece, stretch.v - piece.from.y);
    const Integers first = Integers{0, 1, 2, 3, 4, 5, 6, 7} + stretch.firstGroup * lanes;
    Floats toU = floatsOf(first - piece.to.wholeX), fromU = floatsOf(first - piece.from.wholeX);
    for (std::int32_t group = 0; group < stretch.groups; ++group, toU += lanes, fromU += lanes) {
        Integers low = integers(SpanRows::none), high = integers(-SpanRows::none);
        addRounded(end.at(toU - piece.to.partX), piece.to, low, high);
        if (stretch.withStart) addRounded(start.at(fromU - piece.from.partX), piece.from, low, high);
        if (stretch.moves) addRounded(way.at(fromU - piece.from.partX), piece.from, low, high);
        store(most(low, Integers{}), stretch.low[group]);
        store(least(high, integers(piece.lineEnd)), stretch.high[group]);
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
