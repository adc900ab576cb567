// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"
#include "core/geometry/revolved_piece.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// A leaning piece on its way, as rows of lines meet it: what it covers at both ends, and the walls that the rims of
/// its faces leave between them (a disc moved along the move: an oblique cylinder). What its smooth sides pass between
/// the ends of a short way is within both, to SpanRows::leaningWayError. Lengths: voxels across the runs, run units
/// along them, from the tip.
struct TiltedPiece {
    /// A number that grows evenly over the lines: value at the tip's line, and a line's share of x and y.
    struct Linear {
        double origin = 0.0, x = 0.0, y = 0.0;
    };
    /// What a line passes within `radius` of an axis, and between two planes.
    struct Cylinder {
        Linear aside, middle; ///< of the line from the axis, and the height of its nearest place
        float radius = 0.0F;
        float stretch = 0.0F;   ///< height for a voxel of half chord
        Linear floor;           ///< height of the lower plane
        float thickness = 0.0F; ///< from there to the upper one
    };
    /// The wall that a rim leaves: nowhere, if it leaves none. Its heights are `lift` and `scale` times those of the
    /// cylinder.
    struct Rim {
        Cylinder wall;
        Linear lift;
        float scale = 1.0F;
        float height = 0.0F; ///< voxels along the axis, of the rim
    };
    struct End {
        double x = 0.0, y = 0.0;             ///< voxels, of the tip
        std::int32_t wholeX = 0, wholeY = 0; ///< of these
        std::int32_t base = 0;               ///< run units, that heights count from
        float middle = 0.0F;                 ///< run units from base, of the tip, + 1/2
    };
    enum class Rounding : std::uint8_t { none, ball, bullNose };

    Rounding rounding = Rounding::none;
    End from, to;
    std::int32_t lineEnd = 0;
    bool withStart = true, moves = false; ///< what of the way is asked for
    Cylinder standing;                    ///< the piece's straight part at an end; a bull nose's whole outline
    // A ball: its middle from the tip. A bull nose: the middle of its rounding's circle.
    float middleZ = 0.0F; ///< run units
    double middleX = 0.0, middleY = 0.0;
    float middleHeight = 0.0F, topHeight = 0.0F; ///< voxels along the axis, of that and of the upper face
    Linear equator, face; ///< of a ball: where it goes over into the straight part, and the upper face
    bool rises = true;    ///< that part lies above, not below
    float radius = 0.0F, flatRadius = 0.0F, cornerRadius = 0.0F; ///< voxels
    float axisX = 0.0F, axisY = 0.0F, axisZ = 1.0F;
    bool nearlyLevel = false; ///< where the search for a bull nose's rounding is slow unless it begins near by

    int firstRim = 0;        ///< 1: the lower face has none
    std::array<Rim, 2> rims; ///< of the lower and the upper face, on the way
    /// Square voxels by which radius² and the distance² from the axis differ, in the plane of a face at the end of the
    /// way, on a line that its rim passes.
    float rimReach = 0.0F;
    bool rimsEverywhere = false; ///< any line may be one of those
};

/// Rows of lines that a leaning piece meets, a lane each. Groups are those of eight lines, counted from the grid's.
struct TiltedRows {
    /// Groups with lines that a rim passes on the way: from outerBegin on, but for those from innerBegin to innerEnd.
    struct RimGroups {
        EightIntegers outerBegin, innerBegin, innerEnd, outerEnd;
    };
    std::int32_t first = 0;   ///< row
    EightIntegers begin, end; ///< groups that the piece can meet
    /// Groups whose lines all pass a ball's equator and its upper face at the end of the way, roundings or not: one end
    /// of each lies on the ball, the other on the face.
    EightIntegers ballToFaceBegin, ballToFaceEnd;
    std::array<RimGroups, 2> rims;
};

/// @param piece in voxels; @param axis unit, leaning; @param depth run units that heights may lie below a tip
void setAxis(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis) noexcept;
void setWay(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
            const glm::dvec3& to, double depth) noexcept;

} // namespace burin
