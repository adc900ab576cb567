// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"
#include "core/geometry/revolved_piece.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// A tilted piece during its move, as intersected by rows of lines: what it covers at both ends, and the walls swept by
/// the rims of its faces between them (a disc moved along the move: an oblique cylinder). What its smooth sides pass
/// between the ends of a short move is within both, to SpanRows::leaningWayError. Lengths: voxels across the runs, run
/// units along them, from the tip.
struct TiltedPiece {
    /// A linear function of the line: value at the tip's line, and change per line in x and y.
    struct Linear {
        double origin = 0.0, x = 0.0, y = 0.0;
    };
    /// The part of a line within `radius` of an axis, and between two planes.
    struct Cylinder {
        Linear aside, middle; ///< distance of the line from the axis, and height of its nearest point
        float radius = 0.0F;
        float interval = 0.0F;  ///< height per voxel of half chord
        Linear floor;           ///< height of the lower plane
        float thickness = 0.0F; ///< from there to the upper plane
    };
    /// The wall swept by a rim; empty if there is none. Its heights are `lift` plus `scale` times those of the
    /// cylinder.
    struct Rim {
        Cylinder wall;
        Linear lift;
        float scale = 1.0F;
        float height = 0.0F; ///< voxels along the axis, of the rim
    };
    struct End {
        double x = 0.0, y = 0.0;             ///< voxels, of the tip
        std::int32_t wholeX = 0, wholeY = 0; ///< integer parts of these
        std::int32_t base = 0;               ///< run units, reference of the heights
        float middle = 0.0F;                 ///< run units from base, of the tip, + 1/2
    };
    enum class Rounding : std::uint8_t { none, ball, bullNose };

    Rounding rounding = Rounding::none;
    End from, to;
    std::int32_t lineEnd = 0;
    bool withStart = true, moves = false; ///< the requested part of the move
    Cylinder standing;                    ///< the piece's straight part at an end; a bull nose's entire outline
    // A ball: its centre from the tip. A bull nose: the centre of its rounding's circle.
    float middleZ = 0.0F; ///< run units
    double middleX = 0.0, middleY = 0.0;
    float middleHeight = 0.0F, topHeight = 0.0F; ///< voxels along the axis, of that and of the upper face
    Linear equator, face; ///< of a ball: the transition into the straight part, and the upper face
    bool rises = true;    ///< the straight part lies above, not below
    float radius = 0.0F, flatRadius = 0.0F, cornerRadius = 0.0F; ///< voxels
    float axisX = 0.0F, axisY = 0.0F, axisZ = 1.0F;
    bool nearlyLevel = false; ///< the search for a bull nose's rounding is slow unless it starts close by

    int firstRim = 0;        ///< 1: the lower face has none
    std::array<Rim, 2> rims; ///< of the lower and the upper face, during the move
    /// Largest difference between radius² and distance² from the axis, voxels², in the plane of a face at the end of
    /// the move, on a line that its rim passes.
    float rimReach = 0.0F;
    bool rimsEverywhere = false; ///< any line may be one of those
};

/// Rows of lines that a tilted piece meets, one row per lane. Groups consist of eight lines, counted from the start of
/// the grid.
struct TiltedRows {
    /// Groups with lines that a rim passes during the move: from outerBegin on, except those from innerBegin to
    /// innerEnd.
    struct RimGroups {
        EightIntegers outerBegin, innerBegin, innerEnd, outerEnd;
    };
    std::int32_t first = 0;   ///< row
    EightIntegers begin, end; ///< groups that the piece can meet
    /// Groups whose lines all pass a ball's equator and its upper face at the end of the move, regardless of rounding:
    /// one end of each lies on the ball, the other on the face.
    EightIntegers ballToFaceBegin, ballToFaceEnd;
    std::array<RimGroups, 2> rims;
};

/// @param piece in voxels; @param axis unit, tilted; @param depth run units by which heights may lie below a tip
void setAxis(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis) noexcept;
void setWay(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
            const glm::dvec3& to, double depth) noexcept;

} // namespace burin
