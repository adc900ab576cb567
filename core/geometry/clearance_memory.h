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

/// A point of a tool's axis, and the last result of the mesh for it.
struct AxisPoint {
    double height = 0.0; ///< mm above the tip
    std::size_t piece = 0;
    glm::dvec3 place{0.0}; ///< where it was then
    ClosestPoint nearest;  ///< of the mesh
    bool any = false;      ///< whether there is a result

    /// Whether the point is certainly no deeper in the solid than `depth`: its depth changes no faster than it moves,
    /// and it is no deeper than the distance to any point of the mesh.
    bool isShallower(const glm::dvec3& point, double depth) const noexcept {
        if (!any) return false;
        return nearest.signedDistance - glm::length(point - place) >= -depth ||
               glm::length(point - nearest.point) <= depth;
    }
};

/// No point of the mesh was nearer to the piece; since then the bound decreases by at most the motion of the piece's
/// farthest point.
struct PieceBound {
    double atLeast = -std::numeric_limits<double>::infinity(); ///< mm, may be negative
    ToolPose pose;

    /// Upper bound of the motion of any point of the piece, mm. Of the rotations that take one axis to the other, the
    /// smallest moves a point of the axis with the axis, and a point off the axis by no more than its distance from it
    /// times the chord between the axes in addition.
    double movedBy(const RevolvedPiece& piece, const ToolPose& to) const noexcept {
        const glm::dvec3 moved = to.tip - pose.tip;
        if (to.axis == pose.axis) return glm::length(moved);
        const glm::dvec3 turned = to.axis - pose.axis;
        const double ends =
            std::max(glm::length(moved + piece.bottom * turned), glm::length(moved + piece.top * turned));
        return ends + piece.widestRadius() * glm::length(turned);
    }
};

/// The end spheres of a piece, and the last result of the mesh for the centre of the lower one.
struct PieceInside {
    EndSpheres spheres;
    AxisPoint centre;
};

/// What a ClearanceAsker keeps of its previous results.
struct ClearanceMemory {
    std::array<Found, 4> met{}; ///< the last ones, for as many pieces
    std::vector<AxisPoint> axis;
    std::vector<PieceBound> pieces;
    std::vector<PieceInside> insides; ///< by piece
    bool axisFirst = false;           ///< the last result was the depth of a point of the axis
    std::uint64_t work = 0;           ///< ClearanceAsker::work
};

} // namespace burin
