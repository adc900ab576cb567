// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/face_at.h"

#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>

#include <limits>

namespace burin {

namespace {

struct NearestFace {
    TopoDS_Face face;
    gp_Pnt foot;
    double distance = std::numeric_limits<double>::infinity();
};

NearestFace nearestFace(const TopoDS_Shape& shape, const gp_Pnt& place) {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(place);
    Bnd_Box point;
    point.Set(place);
    NearestFace nearest;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        Bnd_Box box;
        BRepBndLib::Add(face.Current(), box, false);
        if (box.IsVoid() || box.Distance(point) >= nearest.distance) continue;
        const BRepExtrema_DistShapeShape measure(vertex, face.Current());
        if (!measure.IsDone() || measure.NbSolution() == 0 || measure.Value() >= nearest.distance) continue;
        nearest = {TopoDS::Face(face.Current()), measure.PointOnShape2(1), measure.Value()};
    }
    return nearest;
}

/// Outward, at the foot of the place; zero where the surface has none there.
glm::dvec3 normalAt(const NearestFace& nearest) {
    const GeomAPI_ProjectPointOnSurf projection(nearest.foot, BRep_Tool::Surface(nearest.face));
    if (projection.NbPoints() == 0) return glm::dvec3(0.0);
    double u = 0.0, v = 0.0;
    projection.LowerDistanceParameters(u, v);
    gp_Pnt foot;
    gp_Vec normal;
    BRepGProp_Face(nearest.face).Normal(u, v, foot, normal);
    return normal.Magnitude() > 0.0 ? toVector(normal.Normalized().XYZ()) : glm::dvec3(0.0);
}

} // namespace

Result<PartFace> faceAt(const TopoDS_Shape& shape, const glm::dvec3& place) {
    const NearestFace nearest = nearestFace(shape, toPoint(place));
    if (nearest.face.IsNull()) return Error{ErrorCode::fileDamaged, {}, {}, "no face that can be measured"};
    PartFace found;
    found.place = toVector(nearest.foot.XYZ());
    found.direction = normalAt(nearest);
    constexpr double flat = 1e-4; // mm: many files have planes as splines
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
