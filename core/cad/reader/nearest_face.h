// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <glm/glm.hpp>

#include <limits>

namespace burin {

/// The face of a shape that is nearest to a point; the face is null if none can be measured.
struct NearestFace {
    TopoDS_Face face;
    gp_Pnt foot; ///< mm, on the face
    double distance = std::numeric_limits<double>::infinity();
};
NearestFace nearestFace(const TopoDS_Shape& shape, const gp_Pnt& place);

/// Returns the outward unit normal at the foot point; zero if the surface has none there.
glm::dvec3 normalAt(const NearestFace& nearest);

/// Returns the nearest of the face's vertices, midpoints of its edges and centres of its circular edges. For a circle
/// the distance to its rim counts.
gp_Pnt cornerAt(const NearestFace& face, const gp_Pnt& place);

} // namespace burin
