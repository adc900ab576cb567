// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/measure.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BndLib_Add3dCurve.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr double integralTolerance = 1e-6; // relative

struct BoundedFace {
    TopoDS_Face face;
    Bnd_Box quick; // encloses the face with some margin; void if that isn't certain
};

/// OpenCASCADE's box certainly encloses surfaces defined by formulas or poles; others are only sampled.
bool isEnclosed(GeomAbs_SurfaceType type) {
    switch (type) {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus:
    case GeomAbs_BezierSurface:
    case GeomAbs_BSplineSurface:
        return true;
    default:
        return false;
    }
}

/// Returns a box of a curve rotated by a full turn, as most IGES files store a cylinder: that of a cylinder about the
/// axis that contains the curve's own box. Void for a curve that OpenCASCADE only samples.
Bnd_Box boxOfRevolution(const TopoDS_Face& face, const BRepAdaptor_Surface& surface) {
    const Handle(Adaptor3d_Curve) curve = surface.BasisCurve();
    if (curve->GetType() == GeomAbs_OtherCurve || curve->GetType() == GeomAbs_OffsetCurve) return {};
    double firstU = 0.0, lastU = 0.0, firstV = 0.0, lastV = 0.0;
    BRepTools::UVBounds(face, firstU, lastU, firstV, lastV);
    Bnd_Box along, box;
    BndLib_Add3dCurve::Add(*curve, firstV, lastV, Precision::Confusion(), along);
    if (along.IsVoid() || along.IsOpen()) return {};
    const gp_Ax1 axis = surface.AxeOfRevolution();
    const gp_XYZ origin = axis.Location().XYZ(), direction = axis.Direction().XYZ();
    const gp_XYZ low = along.CornerMin().XYZ(), high = along.CornerMax().XYZ();
    for (unsigned corner = 0; corner < 8; ++corner) {
        const gp_XYZ from(((corner & 1U) != 0 ? high : low).X(), ((corner & 2U) != 0 ? high : low).Y(),
                          ((corner & 4U) != 0 ? high : low).Z());
        const gp_XYZ middle = origin + direction * (from - origin).Dot(direction);
        const double radius = (from - middle).Modulus();
        const auto reach = [radius](double cosine) { return radius * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)); };
        const gp_XYZ around(reach(direction.X()), reach(direction.Y()), reach(direction.Z()));
        box.Add(gp_Pnt(middle - around));
        box.Add(gp_Pnt(middle + around));
    }
    return box;
}

/// Returns the faces with their boxes, the largest first.
std::vector<BoundedFace> boundedFaces(const TopoDS_Shape& shape) {
    std::vector<BoundedFace> faces;
    for (TopExp_Explorer parts(shape, TopAbs_FACE); parts.More(); parts.Next()) {
        BoundedFace& bounded = faces.emplace_back(BoundedFace{TopoDS::Face(parts.Current()), {}});
        const BRepAdaptor_Surface surface(bounded.face, Standard_False);
        if (surface.GetType() == GeomAbs_SurfaceOfRevolution)
            bounded.quick = boxOfRevolution(bounded.face, surface);
        else if (isEnclosed(surface.GetType()))
            BRepBndLib::Add(bounded.face, bounded.quick, Standard_False);
    }
    const auto extent = [](const BoundedFace& bounded) {
        return bounded.quick.IsVoid() ? 0.0 : bounded.quick.SquareExtent();
    };
    std::ranges::stable_sort(faces, std::ranges::greater{}, extent);
    return faces;
}

bool liesWithin(const Bnd_Box& inner, const Bnd_Box& outer) {
    if (inner.IsVoid() || outer.IsVoid() || inner.IsOpen()) return false;
    const gp_Pnt low = inner.CornerMin(), high = inner.CornerMax();
    return !outer.IsOut(low) && !outer.IsOut(high);
}

} // namespace

double exactVolume(const TopoDS_Shape& solid) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, integralTolerance);
    return properties.Mass();
}

double exactArea(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties, integralTolerance);
    return properties.Mass();
}

Box exactBox(const TopoDS_Shape& shape) {
    // The tight box of a spline takes up to a second, and most of a part lies within the box of its largest faces.
    Bnd_Box bounds;
    const std::vector<BoundedFace> faces = boundedFaces(shape);
    if (faces.empty()) BRepBndLib::AddOptimal(shape, bounds, Standard_False, Standard_False);
    for (const BoundedFace& bounded : faces)
        if (!liesWithin(bounded.quick, bounds))
            BRepBndLib::AddOptimal(bounded.face, bounds, Standard_False, Standard_False);
    Box box;
    if (bounds.IsVoid()) return box;
    bounds.SetGap(0.0);
    bounds.Get(box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z);
    return box;
}

std::size_t countFaces(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return static_cast<std::size_t>(faces.Extent());
}

} // namespace burin
