// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/face_measure.h"

#include "core/cad/reader/nearest_face.h"
#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <Precision.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <cmath>
#include <limits>

namespace burin {

namespace {

using Kind = MeasuredFace::Kind;

constexpr double flat = 1e-4;       // mm: many files store planes as splines
constexpr double behindFace = 1e-6; // mm, the part of a ray that is ignored when looking for the opposite side

void describe(MeasuredFace& face, Kind kind, const gp_Ax1& axis, double radius) {
    face.kind = kind;
    face.axis = toVector(axis.Direction().XYZ());
    face.axisPlace = toVector(axis.Location().XYZ());
    face.radius = radius;
}

/// Returns the distance from the foot straight in to the next surface.
std::optional<double> thicknessAt(const TopoDS_Shape& shape, const MeasuredFace& face) {
    if (face.normal == glm::dvec3(0.0)) return std::nullopt;
    IntCurvesFace_ShapeIntersector intersector;
    intersector.Load(shape, Precision::Confusion());
    const glm::dvec3 in = -face.normal;
    intersector.Perform(gp_Lin(toPoint(face.place), gp_Dir(in.x, in.y, in.z)), behindFace,
                        std::numeric_limits<float>::max());
    std::optional<double> nearest;
    for (int i = 1; intersector.IsDone() && i <= intersector.NbPnt(); ++i)
        if (const double way = intersector.WParameter(i); !nearest || way < *nearest) nearest = way;
    return nearest;
}

MeasuredFace measured(const TopoDS_Shape& shape, const NearestFace& nearest, const gp_Pnt& asked) {
    MeasuredFace face;
    face.place = toVector(nearest.foot.XYZ());
    face.corner = toVector(cornerAt(nearest, asked).XYZ());
    face.normal = normalAt(nearest);
    describeShape(face, nearest.face, nearest.foot);
    if (face.kind == Kind::plane && face.normal == glm::dvec3(0.0)) face.kind = Kind::other;
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(nearest.face, properties);
    face.area = std::abs(properties.Mass());
    face.thickness = thicknessAt(shape, face);
    return face;
}

} // namespace

void describeShape(MeasuredFace& face, const TopoDS_Face& shape, const gp_Pnt& on) {
    const BRepAdaptor_Surface surface(shape);
    switch (surface.GetType()) {
    case GeomAbs_Cylinder:
        describe(face, Kind::cylinder, surface.Cylinder().Axis(), surface.Cylinder().Radius());
        return;
    case GeomAbs_Cone:
        describe(face, Kind::cone, surface.Cone().Axis(), gp_Lin(surface.Cone().Axis()).Distance(on));
        face.taper = std::abs(surface.Cone().SemiAngle());
        return;
    case GeomAbs_Torus:
        describe(face, Kind::torus, surface.Torus().Axis(), surface.Torus().MinorRadius());
        return;
    case GeomAbs_Sphere:
        face.kind = Kind::sphere;
        face.axisPlace = toVector(surface.Sphere().Location().XYZ());
        face.radius = surface.Sphere().Radius();
        return;
    default:
        if (GeomLib_IsPlanarSurface(BRep_Tool::Surface(shape), flat).IsPlanar()) face.kind = Kind::plane;
    }
}

Result<PartMeasure> faceMeasure(const TopoDS_Shape& shape, std::span<const glm::dvec3> places) {
    std::vector<NearestFace> nearest;
    for (const glm::dvec3& place : places) {
        nearest.push_back(nearestFace(shape, toPoint(place)));
        if (nearest.back().face.IsNull()) return Error{ErrorCode::fileDamaged, {}, {}, "no face that can be measured"};
    }
    if (nearest.empty()) return Error{ErrorCode::fileDamaged, {}, {}, "no face that can be measured"};
    PartMeasure measure;
    measure.from = measured(shape, nearest.front(), toPoint(places.front()));
    if (nearest.size() < 2) return measure;
    measure.to = measured(shape, nearest[1], toPoint(places[1]));
    measure.pair = pairOf(measure.from, *measure.to);
    if (nearest[0].face.IsSame(nearest[1].face)) return measure; // it is 0, which carries no information
    const BRepExtrema_DistShapeShape between(nearest[0].face, nearest[1].face);
    if (!between.IsDone() || between.NbSolution() == 0)
        return Error{ErrorCode::fileDamaged, {}, {}, "no face that can be measured"};
    measure.pair->faces = between.Value();
    measure.pair->nearestFrom = toVector(between.PointOnShape1(1).XYZ());
    measure.pair->nearestTo = toVector(between.PointOnShape2(1).XYZ());
    return measure;
}

} // namespace burin
