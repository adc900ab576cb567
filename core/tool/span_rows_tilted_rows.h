// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/span_rows_kernels.h"

// Internal to core/tool: what a tilted piece covers of rows of lines, eight lines at a time. Rows are prepared eight at
// a time, and then processed one by one.
namespace burin::kernels {

using Linear = TiltedPiece::Linear;
using Rounding = TiltedPiece::Rounding;

/// The intervals of eight lines, units from an end's base; low >= high where there is none.
struct Heights {
    Floats low = floats(nowhere), high = floats(-nowhere);
    BURIN_INLINE void include(const Heights& more) noexcept {
        const Integers meets = more.low < more.high;
        low = meets ? least(low, more.low) : low;
        high = meets ? most(high, more.high) : high;
    }
};

/// Eight rows relative to one end of the move.
struct RowFrames {
    double y[lanes];    ///< voxels from the tip
    double partX = 0.0; ///< fractional part of the tip's x
    BURIN_INLINE RowFrames(const TiltedPiece::End& end, std::int32_t first) noexcept : partX(end.x - end.wholeX) {
        for (int row = 0; row < lanes; ++row) y[row] = first + row - end.y;
    }
};

/// A linear function on each of eight rows: its value at the line at the integer part of an end's x.
struct RowsLinear {
    float origin[lanes], x;
    BURIN_INLINE RowsLinear(const Linear& number, const RowFrames& rows, float more = 0.0F) noexcept
        : x(static_cast<float>(number.x)) {
        for (int row = 0; row < lanes; ++row)
            origin[row] = static_cast<float>(number.origin + number.y * rows.y[row] - number.x * rows.partX) + more;
    }
};
/// A linear function along one row, of lines at an integer number of voxels from the integer part of an end's x.
struct RowLinear {
    float origin, x;
    BURIN_INLINE RowLinear(const RowsLinear& rows, int row) noexcept : origin(rows.origin[row]), x(rows.x) {}
    BURIN_INLINE Floats at(Floats place) const noexcept { return origin + x * place; }
};

struct RowsCylinder {
    RowsLinear aside, middle, floor;
    float radius, interval, thickness;
    BURIN_INLINE RowsCylinder(const TiltedPiece::Cylinder& cylinder, const RowFrames& rows, float more = 0.0F) noexcept
        : aside(cylinder.aside, rows)
        , middle(cylinder.middle, rows, more)
        , floor(cylinder.floor, rows, more)
        , radius(cylinder.radius)
        , interval(cylinder.interval)
        , thickness(cylinder.thickness) {}
};
struct RowCylinder {
    RowLinear aside, middle, floor;
    float radius, interval, thickness;
    BURIN_INLINE RowCylinder(const RowsCylinder& rows, int row) noexcept
        : aside(rows.aside, row)
        , middle(rows.middle, row)
        , floor(rows.floor, row)
        , radius(rows.radius)
        , interval(rows.interval)
        , thickness(rows.thickness) {}

    /// Returns where eight lines meet the cylinder, ignoring its planes.
    BURIN_INLINE Heights unheld(Floats x) const noexcept {
        const Floats off = aside.at(x), inside = (radius - off) * (radius + off);
        const Floats place = middle.at(x), half = interval * rootsOf(inside);
        return {place - half, place + half};
    }
    BURIN_INLINE Heights at(Floats x) const noexcept {
        const Heights all = unheld(x);
        const Floats low = floor.at(x);
        return {most(all.low, low), least(all.high, low + thickness)};
    }
};

/// The piece at one end of its move.
struct RowsPiece {
    const TiltedPiece& piece;
    RowsCylinder standing;
    RowsLinear equator, face;
    float y[lanes];         ///< voxels, of the rows from the rounding's middle
    float square[lanes];    ///< voxels², squared radius of a ball's section in these rows
    float middleX, middleZ; ///< voxels; units from the end's base, + 1/2: of the rounding's middle
    BURIN_INLINE RowsPiece(const TiltedPiece& itsPiece, const TiltedPiece::End& end, std::int32_t first) noexcept
        : RowsPiece(itsPiece, end, RowFrames(end, first)) {}
    BURIN_INLINE RowsPiece(const TiltedPiece& itsPiece, const TiltedPiece::End& end, const RowFrames& rows) noexcept
        : piece(itsPiece)
        , standing(itsPiece.standing, rows, end.middle)
        , equator(itsPiece.equator, rows, end.middle)
        , face(itsPiece.face, rows, end.middle)
        , middleX(static_cast<float>(rows.partX + itsPiece.middleX))
        , middleZ(itsPiece.middleZ + end.middle) {
        for (int row = 0; row < lanes; ++row) {
            y[row] = static_cast<float>(rows.y[row] - itsPiece.middleY);
            square[row] = (itsPiece.radius - y[row]) * (itsPiece.radius + y[row]);
        }
    }
};

/// What the piece covers at one end, in units from the end's base, + 1/2. For a bull nose without its rounding.
template <Rounding rounding, bool rises>
struct RowPiece {
    const TiltedPiece& piece;
    RowCylinder standing;
    RowLinear equator, face;
    float y;       ///< voxels, from the rounding's middle
    float square;  ///< voxels², squared radius of a ball's section in this row
    float middleX; ///< voxels, of the rounding's middle
    float middleZ; ///< units, of the rounding's middle from the end's base, + 1/2
    BURIN_INLINE RowPiece(const RowsPiece& rows, int row) noexcept
        : piece(rows.piece)
        , standing(rows.standing, row)
        , equator(rows.equator, row)
        , face(rows.face, row)
        , y(rows.y[row])
        , square(rows.square[row])
        , middleX(rows.middleX)
        , middleZ(rows.middleZ) {}

    BURIN_INLINE Heights at(Floats x) const noexcept {
        if constexpr (rounding == Rounding::ball)
            return ballAt(x);
        else
            return standing.at(x);
    }
    /// The same for a ball's lines that pass its equator and its upper face.
    BURIN_INLINE Heights ballToFaceAt(Floats x) const noexcept {
        const Floats off = x - middleX, half = unitsAVoxel * rootsOf(square - off * off), end = face.at(x);
        if constexpr (rises)
            return {middleZ - half, end};
        else
            return {end, middleZ + half};
    }
    /// Returns which ends lie in the corner that a bull nose's rounding cuts off: below the circle of the rounding and
    /// outside of it.
    BURIN_INLINE Integers offRounding(Floats x, Floats z) const noexcept {
        const Floats along = x * piece.axisX + y * piece.axisY + z * piece.axisZ;
        const Floats across = x * x + y * y + z * z - along * along;
        return (along < Floats{}) & (across > piece.flatRadius * piece.flatRadius);
    }

private:
    /// The transition of a ball into its straight part is the equator's plane: each end lies on the surface that
    /// belongs to its side of the plane.
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

/// The part between the ends of the move: the wall swept by a rim, relative to the start.
struct RowsRim {
    RowsCylinder wall;
    RowsLinear lift;
    float scale;
    BURIN_INLINE RowsRim(const TiltedPiece::Rim& rim, const TiltedPiece::End& from, std::int32_t first) noexcept
        : RowsRim(rim, from, RowFrames(from, first)) {}
    BURIN_INLINE RowsRim(const TiltedPiece::Rim& rim, const TiltedPiece::End& from, const RowFrames& rows) noexcept
        : wall(rim.wall, rows), lift(rim.lift, rows, from.middle), scale(rim.scale) {}
};
struct RowRim {
    RowCylinder wall;
    RowLinear lift;
    float scale;
    BURIN_INLINE RowRim(const RowsRim& rows, int row) noexcept
        : wall(rows.wall, row), lift(rows.lift, row), scale(rows.scale) {}

    BURIN_INLINE Heights at(Floats x) const noexcept {
        const Heights met = wall.at(x);
        const Floats level = lift.at(x);
        return {level + scale * met.low, level + scale * met.high};
    }
};

} // namespace burin::kernels
