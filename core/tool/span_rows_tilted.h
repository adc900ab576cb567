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
/// its faces leave between them (a disc moved along the way: an oblique cylinder). What its smooth sides pass between
/// the ends of a short way is within both, to SpanRows::leaningWayError. Lengths: voxels across the runs, run units
/// along them, from the tip.
struct TiltedPiece {
    /// A number that grows evenly over the lines: value at the tip's line, and a line's share of x and y.
    struct Linear {
        double origin = 0.0, x = 0.0, y = 0.0;
    };
    /// Heights within `half` of the middle.
    struct Slab {
        Linear middle;
        float half = 0.0F;
    };
    /// What a line passes within `radius` of an axis, and within a slab.
    struct Cylinder {
        Linear aside, middle; ///< of the line from the axis, and the height of its nearest place
        float radius = 0.0F;
        float stretch = 0.0F; ///< height for a voxel of half chord
        Slab slab;
        bool present = false;
    };
    /// The wall that a rim leaves. Its heights are `lift` and `scale` times those of the cylinder.
    struct Rim {
        Cylinder wall;
        Linear lift;
        float scale = 1.0F;
    };
    struct End {
        double x = 0.0, y = 0.0; ///< voxels, of the tip
        std::int32_t wholeX = 0; ///< of x
        float partX = 0.0F;      ///< the rest
        std::int32_t base = 0;   ///< run units, that heights count from
        float middle = 0.0F;     ///< run units from base, of the tip, + 1/2
    };
    enum class Rounding : std::uint8_t { none, ball, bullNose };

    Rounding rounding = Rounding::none;
    End from, to;
    std::int32_t lineEnd = 0;
    bool withStart = true, moves = false; ///< what of the way is asked for
    Cylinder standing;                    ///< the piece's straight part at an end; a bull nose's whole outline
    Slab hemisphere;                      ///< what of a ball is not within the straight part
    // Ball: its middle from the tip. Bull nose: the middle of its rounding's circle.
    float middleX = 0.0F, middleZ = 0.0F; ///< voxels; middleZ run units
    double middleY = 0.0;
    float radius = 0.0F, flatRadius = 0.0F, cornerRadius = 0.0F; ///< voxels
    float axisX = 0.0F, axisY = 0.0F, axisZ = 1.0F;
    bool nearlyLevel = false; ///< where the search for a bull nose's rounding is slow unless it begins near by

    std::array<Rim, 2> rims; ///< of the lower and the upper face, on the way
    /// Voxels along the axis' shadow, of the line's nearest place to the axis: from the middle of the straight part's
    /// slab to its upper face.
    float rimAlong = 0.0F;
    float perStretch = 0.0F; ///< of the straight part
    /// Square voxels by which radius² and the distance² from the axis differ, in the plane of a face at the end of the
    /// way, on a line that its rim passes.
    float rimReach = 0.0F;
    bool rimsEverywhere = false; ///< any line may be one of those
};

/// @param piece in voxels; @param axis unit, leaning; @param depth run units that heights may lie below a tip
void setAxis(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis) noexcept;
void setWay(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
            const glm::dvec3& to, double depth) noexcept;

} // namespace burin
