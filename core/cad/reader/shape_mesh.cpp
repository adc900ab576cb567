// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/shape_mesh.h"

#include "core/cad/reader/polygon_fill.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace burin {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr double edgeAngle = 0.5; // rad

glm::dvec3 toVector(const gp_Pnt& point) {
    return {point.X(), point.Y(), point.Z()};
}

std::size_t index(int number) {
    return static_cast<std::size_t>(number - 1);
} // OpenCASCADE counts from 1

std::uint64_t edgeKey(std::uint64_t a, std::uint64_t b) {
    return a < b ? (a << 32) | b : (b << 32) | a;
}

/// Twice the signed area of a loop.
double loopArea(const std::vector<PolygonCorner>& loop) {
    double area = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 &a = loop[i].place, &b = loop[(i + 1) % loop.size()].place;
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

} // namespace

std::vector<TopoDS_Face> meshedFaces(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer each(shape, TopAbs_FACE); each.More(); each.Next()) {
        const TopoDS_Face face = TopoDS::Face(each.Current());
        if (face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED) faces.push_back(face);
    }
    return faces;
}

ShapeMesh::ShapeMesh(const TopoDS_Shape& shape, double chord) : chord_(chord) {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, corners_);
    edgePoints_.resize(static_cast<std::size_t>(edges_.Extent()));
    cornerPoints_.resize(static_cast<std::size_t>(corners_.Extent()), none);
    for (const TopoDS_Face& face : meshedFaces(shape)) addFace(face);
}

std::uint32_t ShapeMesh::addPoint(const glm::dvec3& point) {
    points_.push_back(point);
    return static_cast<std::uint32_t>(points_.size() - 1);
}

std::uint32_t ShapeMesh::vertexOf(const TopoDS_Shape& vertex) {
    std::uint32_t& point = cornerPoints_[index(corners_.FindIndex(vertex))];
    if (point == none) point = addPoint(toVector(BRep_Tool::Pnt(TopoDS::Vertex(vertex))));
    return point;
}

void ShapeMesh::shareEdges(const TopoDS_Face& face, std::vector<std::uint32_t>& nodes) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        const Handle(Poly_PolygonOnTriangulation) polygon =
            BRep_Tool::PolygonOnTriangulation(edge, triangulation, place);
        if (polygon.IsNull()) continue;
        std::vector<std::uint32_t>& shared = edgePoints_[index(edges_.FindIndex(edge))];
        const auto size = static_cast<std::size_t>(polygon->NbNodes());
        if (shared.size() < size) shared.resize(size, none);
        const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
        const bool pole = BRep_Tool::Degenerated(edge);
        for (std::size_t i = 0; i < size; ++i) {
            std::uint32_t& node = nodes[index(polygon->Node(static_cast<int>(i) + 1))];
            if (!first.IsNull() && (i == 0 || pole))
                shared[i] = vertexOf(first);
            else if (!last.IsNull() && i + 1 == size)
                shared[i] = vertexOf(last);
            else if (shared[i] == none && node == none)
                shared[i] = addPoint(toVector(
                    triangulation->Node(polygon->Node(static_cast<int>(i) + 1)).Transformed(place.Transformation())));
            else if (shared[i] == none)
                shared[i] = node;
            node = shared[i];
        }
    }
}

void ShapeMesh::addFace(const TopoDS_Face& face) {
    faces_.push_back({face, {}});
    FaceMesh& mesh = faces_.back().mesh;
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
    if (triangulation.IsNull()) return;
    const auto count = static_cast<std::size_t>(triangulation->NbNodes());
    mesh.nodes.resize(count, none);
    shareEdges(face, mesh.nodes);
    for (std::size_t i = 0; i < count; ++i) {
        const int number = static_cast<int>(i) + 1;
        if (mesh.nodes[i] == none)
            mesh.nodes[i] = addPoint(toVector(triangulation->Node(number).Transformed(place.Transformation())));
        if (triangulation->HasUVNodes())
            mesh.parameters.emplace_back(triangulation->UVNode(number).X(), triangulation->UVNode(number).Y());
    }
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangulation->Triangle(i).Get(a, b, c);
        if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
        mesh.triangles.push_back(
            {static_cast<std::uint32_t>(a - 1), static_cast<std::uint32_t>(b - 1), static_cast<std::uint32_t>(c - 1)});
    }
}

std::vector<std::size_t> ShapeMesh::emptyFaces() const {
    std::vector<std::size_t> empty;
    for (std::size_t face = 0; face < faces_.size(); ++face)
        if (faces_[face].mesh.triangles.empty()) empty.push_back(face);
    return empty;
}

template <class Visit>
void ShapeMesh::visitEdges(const FaceMesh& mesh, Visit visit) {
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = mesh.nodes[triangle[i]], to = mesh.nodes[triangle[(i + 1) % 3]];
            if (from != to) visit(edgeKey(from, to), from < to ? 1 : -1);
        }
}

std::vector<ShapeMesh::Border> ShapeMesh::bordersOf(const FaceMesh& mesh) {
    std::vector<Border> uses;
    uses.reserve(3 * mesh.triangles.size());
    visitEdges(mesh, [&](std::uint64_t edge, int direction) { uses.push_back({edge, direction}); });
    std::sort(uses.begin(), uses.end(), [](const Border& a, const Border& b) { return a.edge < b.edge; });
    std::vector<Border> borders;
    for (std::size_t i = 0; i < uses.size();) {
        Border sum{uses[i].edge, 0};
        for (; i < uses.size() && uses[i].edge == sum.edge; ++i) sum.balance += uses[i].balance;
        if (sum.balance != 0) borders.push_back(sum);
    }
    return borders;
}

std::vector<std::size_t> ShapeMesh::facesAtOpenEdges() const {
    std::vector<std::vector<Border>> borders;
    std::unordered_map<std::uint64_t, int> balance; // of all faces
    for (const Face& face : faces_) {
        borders.push_back(bordersOf(face.mesh));
        for (const Border& border : borders.back()) balance[border.edge] += border.balance;
    }
    std::vector<std::size_t> numbers;
    for (std::size_t face = 0; face < faces_.size(); ++face)
        if (std::any_of(borders[face].begin(), borders[face].end(),
                        [&](const Border& border) { return balance[border.edge] != 0; }))
            numbers.push_back(face);
    return numbers;
}

bool ShapeMesh::isFolded(const FaceMesh& mesh) {
    if (mesh.parameters.size() != mesh.nodes.size()) return false; // filled from its border
    constexpr double rounding = 1e-6;                              // of the area in parameters
    double forward = 0.0, backward = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const glm::dvec2 &a = mesh.parameters[triangle[0]], &b = mesh.parameters[triangle[1]],
                         &c = mesh.parameters[triangle[2]];
        const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        (area > 0.0 ? forward : backward) += std::abs(area);
    }
    return std::min(forward, backward) > rounding * std::max(forward, backward);
}

bool ShapeMesh::isTorn(const Face& face) const {
    if (face.mesh.triangles.empty() || isFolded(face.mesh)) return true;
    // A seam is visited twice, and its two sides cancel out as its triangles do.
    std::map<std::uint64_t, int> expected;
    for (TopExp_Explorer edges(face.shape, TopAbs_EDGE); edges.More(); edges.Next()) {
        const std::vector<std::uint32_t>& points = edgePoints_[index(edges_.FindIndex(edges.Current()))];
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            if (points[i] == points[i + 1]) continue;
            const int along = points[i] < points[i + 1] ? 1 : -1;
            switch (edges.Current().Orientation()) {
            case TopAbs_FORWARD:
                expected[edgeKey(points[i], points[i + 1])] += along;
                break;
            case TopAbs_REVERSED:
                expected[edgeKey(points[i], points[i + 1])] -= along;
                break;
            default: // runs within the face
                break;
            }
        }
    }
    std::erase_if(expected, [](const auto& entry) { return entry.second == 0; });
    const std::vector<Border> borders = bordersOf(face.mesh);
    return !std::equal(borders.begin(), borders.end(), expected.begin(), expected.end(),
                       [](const Border& a, const auto& b) { return a.edge == b.first && a.balance == b.second; });
}

std::vector<std::size_t> ShapeMesh::tornFaces() const {
    std::vector<std::size_t> torn;
    for (std::size_t face = 0; face < faces_.size(); ++face)
        if (isTorn(faces_[face])) torn.push_back(face);
    return torn;
}

void ShapeMesh::splitChord(FaceMesh& mesh, std::uint32_t from, std::uint32_t to, std::uint32_t middle) {
    const auto node = static_cast<std::uint32_t>(mesh.nodes.size());
    mesh.nodes.push_back(middle);
    mesh.parameters.clear(); // unknown for the new node; refining is over by now
    const std::size_t count = mesh.triangles.size();
    for (std::size_t triangle = 0; triangle < count; ++triangle)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corners = mesh.triangles[triangle];
            const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
            if (edgeKey(mesh.nodes[a], mesh.nodes[b]) != edgeKey(from, to)) continue;
            mesh.triangles[triangle] = {a, node, c};
            mesh.triangles.push_back({node, b, c});
            break;
        }
}

void ShapeMesh::partSharedChords() {
    // Points inside a face cannot share a chord with another face.
    std::vector<bool> onEdge(points_.size(), false);
    for (const std::vector<std::uint32_t>& along : edgePoints_)
        for (const std::uint32_t point : along) onEdge[point] = true;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> users; // faces, once for each triangle at the edge
    for (std::size_t face = 0; face < faces_.size(); ++face)
        visitEdges(faces_[face].mesh, [&](std::uint64_t edge, int) {
            if (onEdge[edge >> 32] && onEdge[static_cast<std::uint32_t>(edge)]) users[edge].push_back(face);
        });
    for (auto& [edge, faces] : users) {
        if (faces.size() <= 2) continue;
        const auto from = static_cast<std::uint32_t>(edge >> 32), to = static_cast<std::uint32_t>(edge);
        std::sort(faces.begin(), faces.end());
        // Inside a face its chord is used twice; a use on the face's border is single and stays.
        for (std::size_t i = 0; i + 1 < faces.size(); ++i)
            if (faces[i] == faces[i + 1] && std::count(faces.begin(), faces.end(), faces[i]) == 2)
                splitChord(faces_[faces[i]].mesh, from, to, addPoint(0.5 * (points_[from] + points_[to])));
    }
}

void ShapeMesh::refine() {
    for (Face& face : faces_) refineFace(BRepAdaptor_Surface(face.shape, Standard_False), chord_, face.mesh, points_);
}

const std::vector<std::uint32_t>& ShapeMesh::pointsAlong(const TopoDS_Shape& shape) {
    std::vector<std::uint32_t>& shared = edgePoints_[index(edges_.FindIndex(shape))];
    if (!shared.empty()) return shared;
    const TopoDS_Edge edge = TopoDS::Edge(shape.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (first.IsNull() || last.IsNull()) return shared;
    shared.push_back(vertexOf(first));
    if (!BRep_Tool::Degenerated(edge)) {
        const BRepAdaptor_Curve curve(edge);
        const GCPnts_TangentialDeflection points(curve, edgeAngle, chord_);
        for (int i = 2; i < points.NbPoints(); ++i) shared.push_back(addPoint(toVector(points.Value(i))));
    }
    shared.push_back(vertexOf(last));
    return shared;
}

std::vector<std::uint32_t> ShapeMesh::loopOf(const TopoDS_Shape& wire, const TopoDS_Face& face) {
    int expected = 0, met = 0;
    for (TopoDS_Iterator edges(wire); edges.More(); edges.Next()) ++expected;
    std::vector<std::uint32_t> loop;
    for (BRepTools_WireExplorer edges(TopoDS::Wire(wire), face); edges.More(); edges.Next(), ++met) {
        std::vector<std::uint32_t> points = pointsAlong(edges.Current());
        if (points.size() < 2) return {};
        if (edges.Current().Orientation() == TopAbs_REVERSED) std::reverse(points.begin(), points.end());
        if (!loop.empty() && loop.back() != points.front()) return {};
        if (!loop.empty()) loop.pop_back();
        loop.insert(loop.end(), points.begin(), points.end());
    }
    if (met != expected || loop.size() < 4 || loop.front() != loop.back()) return {};
    loop.pop_back();
    return loop;
}

bool ShapeMesh::fillPlaneFace(std::size_t number) {
    const TopoDS_Face face = TopoDS::Face(faces_[number].shape.Oriented(TopAbs_FORWARD));
    const BRepAdaptor_Surface surface(face, Standard_False);
    if (surface.GetType() != GeomAbs_Plane) return false;
    std::vector<std::vector<PolygonCorner>> loops;
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    for (TopoDS_Iterator wires(face); wires.More(); wires.Next()) {
        if (wires.Value().ShapeType() != TopAbs_WIRE) continue;
        std::vector<PolygonCorner> loop;
        for (const std::uint32_t vertex : loopOf(wires.Value(), face)) {
            PolygonCorner corner{{}, vertex};
            const glm::dvec3& p = points_[vertex];
            ElSLib::Parameters(surface.Plane(), gp_Pnt(p.x, p.y, p.z), corner.place.x, corner.place.y);
            loop.push_back(corner);
        }
        if (loop.empty()) return false;
        const bool first = wires.Value().IsSame(outer);
        loops.insert(first ? loops.begin() : loops.end(), std::move(loop));
    }
    for (std::size_t i = 0; i < loops.size(); ++i)
        if ((loopArea(loops[i]) > 0.0) != (i == 0)) return false;
    FaceMesh filled;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    for (auto triangle : fillPolygon(std::move(loops))) {
        if (faces_[number].shape.Orientation() == TopAbs_REVERSED) std::swap(triangle[1], triangle[2]);
        for (std::uint32_t& corner : triangle) {
            const auto [node, added] = numbers.try_emplace(corner, static_cast<std::uint32_t>(filled.nodes.size()));
            if (added) filled.nodes.push_back(corner);
            corner = node->second;
        }
        filled.triangles.push_back(triangle);
    }
    if (filled.triangles.empty()) return false;
    faces_[number].mesh = std::move(filled);
    return true;
}

TriangleMesh ShapeMesh::mesh(std::vector<std::uint32_t>* faceOf) const {
    // Points used only by dropped triangles are left out.
    TriangleMesh mesh;
    std::vector<std::uint32_t> numbers(points_.size(), none);
    const auto numberOf = [&](std::uint32_t point) {
        std::uint32_t& number = numbers[point];
        if (number == none) {
            number = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(points_[point]);
        }
        return number;
    };
    for (std::size_t number = 0; number < faces_.size(); ++number)
        for (const auto& triangle : faces_[number].mesh.triangles) {
            const std::vector<std::uint32_t>& nodes = faces_[number].mesh.nodes;
            const std::uint32_t a = nodes[triangle[0]], b = nodes[triangle[1]], c = nodes[triangle[2]];
            // A pole's nodes are the same point: the triangles between them vanish.
            if (a == b || b == c || c == a) continue;
            mesh.triangles.push_back({numberOf(a), numberOf(b), numberOf(c)});
            if (faceOf != nullptr) faceOf->push_back(static_cast<std::uint32_t>(number));
        }
    return mesh;
}

} // namespace burin
