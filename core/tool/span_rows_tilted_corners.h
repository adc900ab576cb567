// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/span_rows_tilted_rows.h"

#include <bit>

// Internal to core/tool: the rounding of a tilted bull nose.
namespace burin::kernels {

// The search for a bull nose's rounding ends when no line's end moves by more than `nearEnough` in a step, and none
// that has not met the rounding yet by more than `nearlyStill`. This takes three or four steps, except for nearly
// horizontal axes.
inline constexpr float nearEnough = 1.0F / 256.0F, nearlyStill = 1.0F / 16384.0F; // voxels
inline constexpr int mostSteps = 64;

/// For a nearly horizontal axis: returns the point on the line where the piece is as wide as at the height of another
/// point.
BURIN_INLINE Floats atHeightOf(const TiltedPiece& piece, Floats flatSquare, Floats flatAlong, Floats z,
                               float side) noexcept {
    const Floats along = least(flatAlong + z * piece.axisZ, Floats{});
    const Floats wide = piece.flatRadius + rootsOf(piece.cornerRadius * piece.cornerRadius - along * along);
    const float perSquare = 1.0F / (1.0F - piece.axisZ * piece.axisZ);
    const Floats middle = flatAlong * (piece.axisZ * perSquare);
    return middle - side * rootsOf(middle * middle - (flatSquare - flatAlong * flatAlong - wide * wide) * perSquare);
}

/// The ends of some lines' intervals within a bull nose's outline, eight lines at a time, in one row.
template <std::size_t count>
struct CornerEnds {
    Floats x[count];      ///< voxels from the rounding's middle
    Floats z[count];      ///< voxels from the rounding's middle, of the ends
    Integers outs[count]; ///< lines whose end lies off the rounding
};

/// Moves ends onto the rounding, which is the union of balls centred on a circle: each step uses the ball that lies
/// outwards from the axis in the direction of the previous point. No step leaves the piece, and as the circle is
/// smooth, the remaining distance of a step is proportional to the square of the error of its direction.
/// Several at a time: a step is a chain of roots and a division, which can be interleaved with others.
/// @param side 1: lower ends, -1: upper ends @param ends lines that miss the rounding are removed from `outs`
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

/// Heights of some groups of a row.
struct Part {
    static constexpr std::int32_t mostGroups = 64; ///< the bits of one word
    EightFloats low[mostGroups], high[mostGroups];
};

/// Moves ends in the corners that the rounding of a bull nose cuts off onto the rounding; `count` groups at a time; a
/// single last group is paired with itself.
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

/// Computes what a bull nose covers of some groups.
BURIN_INLINE void coverPart(const RowPiece<Rounding::bullNose, true>& row, Floats firstU, std::int32_t count,
                            Part& part) noexcept {
    std::uint64_t offLow = 0, offHigh = 0; // one bit per group: it has ends that the rounding cuts off
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

} // namespace burin::kernels
