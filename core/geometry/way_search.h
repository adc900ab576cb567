// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/geometry/triangle_tree.h"

#include <glm/glm.hpp>

namespace burin {

/// Whether a piece of a tool whose tip moves straight, without rotation, keeps at least `clearance` mm from every point
/// of a mesh; negative: no point of the mesh lies deeper in it than that. True is certain, except for 1e-8 mm; false
/// means that it does not or that it could not be shown. A whole move costs little more than one position of it.
///
/// With d the piece's signed distance, d(x - s · way) is convex in the point x and the share s together. So the tangent
/// of the piece's distance at one position of the move, lowered by as much as the motion can reduce it, stays below the
/// distance of the piece at all its positions, over a box, a plate or a triangle.
/// @param axis  unit length
bool keepsFromMesh(const TriangleTree& tree, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
                   const glm::dvec3& to, double clearance) noexcept;

/// Spheres about points of a piece's axis, each inside the piece and touching one of its ends on the axis. If no point
/// of a mesh lies deeper in the piece than `depth`, less than their radii, and one of the centres is outside the solid,
/// then no point of the piece's axis is deeper in the solid than `depth`: the axis between the centres does not touch
/// the mesh, so all of it is outside, and the centres by their radius less `depth`; and a point's signed distance
/// changes no faster than the point moves.
struct EndSpheres {
    double height = 0.0;      ///< mm above the tip, centre of the lower one
    double leastRadius = 0.0; ///< mm; 0: one end does not have one (a sharp tip)
};
EndSpheres endSpheres(const RevolvedPiece& piece) noexcept;

} // namespace burin
