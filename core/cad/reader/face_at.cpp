// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/face_at.h"

#include "core/cad/reader/nearest_face.h"
#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>

namespace burin {

Result<PartFace> faceAt(const TopoDS_Shape& shape, const glm::dvec3& place) {
    const NearestFace nearest = nearestFace(shape, toPoint(place));
    if (nearest.face.IsNull()) return Error{ErrorCode::fileDamaged, {}, {}, "no face that can be measured"};
    PartFace found;
    found.place = toVector(nearest.foot.XYZ());
    found.direction = normalAt(nearest);
    found.corner = toVector(cornerAt(nearest, toPoint(place)).XYZ());
    constexpr double flat = 1e-4; // mm: many files store planes as splines
    const BRepAdaptor_Surface surface(nearest.face);
    if (surface.GetType() == GeomAbs_Cylinder || surface.GetType() == GeomAbs_Cone) {
        found.kind = PartFace::Kind::round;
        const gp_Ax1 axis = surface.GetType() == GeomAbs_Cylinder ? surface.Cylinder().Axis() : surface.Cone().Axis();
        found.direction = toVector(axis.Direction().XYZ());
    } else if (GeomLib_IsPlanarSurface(BRep_Tool::Surface(nearest.face), flat).IsPlanar()) {
        found.kind = PartFace::Kind::plane;
    }
    if (found.direction == glm::dvec3(0.0)) found.kind = PartFace::Kind::other;
    return found;
}

} // namespace burin
