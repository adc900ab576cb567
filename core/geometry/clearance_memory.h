// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/geometry/piece_search.h"
#include "core/geometry/way_search.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace burin {

/// A point of a tool's axis, and what was asked of the mesh for it last.
struct AxisPoint {
    double height = 0.0; ///< mm above the tip
    std::size_t piece = 0;
    glm::dvec3 place{0.0}; ///< where it was
    ClosestPoint nearest;  ///< of the mesh
    bool any = false;      ///< it was asked

    /// Whether it is certainly no deeper in the solid than so much: its depth changes no faster than it moves, nor is
    /// it deeper than any point of the mesh is away.
    bool isShallower(const glm::dvec3& point, double depth) const noexcept {
        if (!any) return false;
        return nearest.signedDistance - glm::length(point - place) >= -depth ||
               glm::length(point - nearest.point) <= depth;
    }
};

/// No point of the mesh was nearer to a piece, and none is by more than the piece's farthest point has moved since.
struct PieceBound {
    double atLeast = -std::numeric_limits<double>::infinity(); ///< mm, may be negative
    ToolPose pose;

    /// mm: no point of the piece moves by more. Of the turns that take one axis to the other, the least one moves a
    /// point of the axis with it, and one beside it by no more than its distance times the axis' chord on top.
    double movedBy(const RevolvedPiece& piece, const ToolPose& to) const noexcept {
        const glm::dvec3 moved = to.tip - pose.tip;
        if (to.axis == pose.axis) return glm::length(moved);
        const glm::dvec3 turned = to.axis - pose.axis;
        const double ends =
            std::max(glm::length(moved + piece.bottom * turned), glm::length(moved + piece.top * turned));
        return ends + piece.widestRadius() * glm::length(turned);
    }
};

/// A piece's spheres, and what was asked of the mesh for the lower one's centre last.
struct PieceInside {
    EndSpheres spheres;
    AxisPoint centre;
};

/// What a ClearanceAsker keeps of its last answers.
struct ClearanceMemory {
    std::array<Found, 4> met{}; ///< the last, of as many pieces
    std::vector<AxisPoint> axis;
    std::vector<PieceBound> pieces;
    std::vector<PieceInside> insides; ///< by piece
    bool axisFirst = false;           ///< the last answer was the depth of a point of the axis
    std::uint64_t work = 0;           ///< ClearanceAsker::work
};

} // namespace burin
