// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/nearest_face.h"

#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>

namespace burin {

namespace {

/// Keeps the corner that is nearest to a point.
class NearestCorner {
public:
    explicit NearestCorner(const gp_Pnt& place) : place_(place) {}
    /// @param distance from the point to the feature that represents the corner
    void offer(const gp_Pnt& corner, double distance) {
        if (distance >= distance_) return;
        distance_ = distance;
        corner_ = corner;
    }
    void offer(const gp_Pnt& corner) { offer(corner, corner.Distance(place_)); }
    bool found() const { return distance_ < std::numeric_limits<double>::infinity(); }
    const gp_Pnt& corner() const { return corner_; }

private:
    gp_Pnt place_, corner_;
    double distance_ = std::numeric_limits<double>::infinity();
};

/// Offers the centre of a circle with the distance to its rim: users can't point at the middle of a bore, where there
/// is no face.
void offerCentre(const TopoDS_Edge& edge, const BRepAdaptor_Curve& curve, const gp_Pnt& place, NearestCorner& nearest) {
    const BRepExtrema_DistShapeShape rim(BRepBuilderAPI_MakeVertex(place), edge);
    if (rim.IsDone() && rim.NbSolution() > 0) nearest.offer(curve.Circle().Location(), rim.Value());
}

} // namespace

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

gp_Pnt cornerAt(const NearestFace& face, const gp_Pnt& place) {
    NearestCorner nearest(place);
    for (TopExp_Explorer each(face.face, TopAbs_EDGE); each.More(); each.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(each.Current());
        // Degenerate edges and seams of closed faces are not corners either.
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face.face)) continue;
        const BRepAdaptor_Curve curve(edge);
        const bool circular = curve.GetType() == GeomAbs_Circle;
        if (circular) offerCentre(edge, curve, place, nearest);
        const double first = curve.FirstParameter(), last = curve.LastParameter();
        const bool whole = curve.Value(first).Distance(curve.Value(last)) < Precision::Confusion();
        if (circular && whole) continue; // the position of its seam is arbitrary
        nearest.offer(curve.Value(first));
        nearest.offer(curve.Value(last));
        const double half = 0.5 * GCPnts_AbscissaPoint::Length(curve);
        const GCPnts_AbscissaPoint middle(curve, half, first);
        if (middle.IsDone()) nearest.offer(curve.Value(middle.Parameter()));
    }
    return nearest.found() ? nearest.corner() : face.foot;
}

} // namespace burin
