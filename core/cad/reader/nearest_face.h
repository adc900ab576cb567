// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <glm/glm.hpp>

#include <limits>

namespace burin {

/// The face of a shape that is nearest to a place; a null face: none can be measured.
struct NearestFace {
    TopoDS_Face face;
    gp_Pnt foot; ///< mm, on the face
    double distance = std::numeric_limits<double>::infinity();
};
NearestFace nearestFace(const TopoDS_Shape& shape, const gp_Pnt& place);

/// Unit, outward, at the foot of the place; zero where the surface has none there.
glm::dvec3 normalAt(const NearestFace& nearest);

/// What is nearest to a place: a vertex of the face, the middle of one of its edges, or the centre of a circular one,
/// which counts by its rim.
gp_Pnt cornerAt(const NearestFace& face, const gp_Pnt& place);

} // namespace burin
