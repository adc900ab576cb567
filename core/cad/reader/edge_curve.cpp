// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/edge_curve.h"

#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Vec.hxx>

#include <optional>

namespace burin {
namespace {

constexpr double largestTurn = 0.1; // rad between neighbouring points' tangents
constexpr int fewestPoints = 2;
constexpr double nothing = 1e-9; // mm

/// A closed face has its seam on both sides.
bool isSeam(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
    return faces.Extent() < 2 || (faces.Extent() == 2 && faces.First().IsSame(faces.Last()) &&
                                  BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First())));
}

/// Returns the unit tangent; empty if the derivative vanishes there (a pole of its parameters).
std::optional<glm::dvec3> tangentAt(const BRepAdaptor_Curve& curve, double parameter) {
    gp_Pnt place;
    gp_Vec speed;
    curve.D1(parameter, place, speed);
    if (speed.Magnitude() < nothing) return std::nullopt;
    return toVector(speed.Normalized().XYZ());
}

std::optional<PartEdge> curveOf(const TopoDS_Edge& edge, double chord) {
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection places(curve, largestTurn, chord, fewestPoints);
    PartEdge result;
    std::vector<double> parameters;
    for (int i = 1; i <= places.NbPoints(); ++i) {
        const glm::dvec3 point = toVector(places.Value(i).XYZ());
        const double step = result.points.empty() ? 0.0 : glm::distance(point, result.points.back());
        if (!result.points.empty() && step < nothing) continue;
        result.length += step;
        result.points.push_back(point);
        parameters.push_back(places.Parameter(i));
    }
    const std::size_t count = result.points.size();
    if (count < 2) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t from = i > 0 ? i - 1 : 0, to = i + 1 < count ? i + 1 : i;
        const glm::dvec3 chordWay = glm::normalize(result.points[to] - result.points[from]);
        result.tangents.push_back(tangentAt(curve, parameters[i]).value_or(chordWay));
    }
    return result;
}

} // namespace

std::vector<PartEdge> edgeCurves(const TopoDS_Shape& shape, double chord) {
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
    std::vector<PartEdge> edges;
    for (int i = 1; i <= facesOfEdges.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(facesOfEdges.FindKey(i));
        if (BRep_Tool::Degenerated(edge) || isSeam(edge, facesOfEdges(i))) continue;
        if (std::optional<PartEdge> curve = curveOf(edge, chord)) edges.push_back(std::move(*curve));
    }
    return edges;
}

} // namespace burin
