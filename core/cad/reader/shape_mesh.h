// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/face_mesh.h"
#include "core/geometry/triangle_mesh.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// The triangles of a meshed shape, face by face, with vertices shared along its edges: welded by the topology, not by
/// distance, so that no gap is closed which the shape has, and none is left which it has not.
class ShapeMesh {
public:
    /// @param shape meshed by OpenCASCADE; outlives this.
    /// @param chord mm, for edges that no meshed face knows.
    ShapeMesh(const TopoDS_Shape& shape, double chord);

    /// Numbers of the faces that have no triangles.
    std::vector<std::size_t> emptyFaces() const;
    /// Numbers of the faces with a triangle at an open edge.
    std::vector<std::size_t> facesAtOpenEdges() const;
    /// Numbers of the faces whose triangles end elsewhere than at the edges of the face, or are folded over in its
    /// parameters: those of the others cover their face once, without a hole. A face at an open edge that isn't among
    /// them lies at a gap of the shape itself. Call before refining.
    std::vector<std::size_t> tornFaces() const;
    const TopoDS_Face& face(std::size_t number) const { return faces_[number].shape; }
    /// Triangulates a plane face anew from its boundary alone. False when it is not plane or its boundary is broken:
    /// then nothing has changed.
    bool fillPlaneFace(std::size_t face);

    /// Two faces may both draw a chord between the same two corners, which makes four triangles meet at one edge. Gives
    /// each such chord a point of its own in its middle; the surface stays the same.
    void partSharedChords();

    /// Brings every face within the chord of its surface.
    void refine();

    /// All faces in one mesh, mm, without points that no triangle has.
    TriangleMesh mesh() const;

private:
    struct Face {
        TopoDS_Face shape;
        FaceMesh mesh;
    };

    /// An edge of triangles, and how often it is used from its lower vertex to its higher less the other way round.
    struct Border {
        std::uint64_t edge = 0;
        int balance = 0;
    };

    template <class Visit>
    static void visitEdges(const FaceMesh& mesh, Visit visit);
    /// Where the triangles of one face end, in the order of the edges' keys.
    static std::vector<Border> bordersOf(const FaceMesh& mesh);
    bool isTorn(const Face& face) const;
    static bool isFolded(const FaceMesh& mesh);
    void addFace(const TopoDS_Face& face);
    static void splitChord(FaceMesh& face, std::uint32_t from, std::uint32_t to, std::uint32_t middle);
    std::uint32_t vertexOf(const TopoDS_Shape& vertex);
    std::uint32_t addPoint(const glm::dvec3& point);
    void shareEdges(const TopoDS_Face& face, std::vector<std::uint32_t>& nodes);
    /// Vertices along an edge in the order of its parameter; made from the curve when no face has meshed it.
    const std::vector<std::uint32_t>& pointsAlong(const TopoDS_Shape& edge);
    std::vector<std::uint32_t> loopOf(const TopoDS_Shape& wire, const TopoDS_Face& face);

    double chord_;
    TopTools_IndexedMapOfShape edges_, corners_;
    std::vector<std::vector<std::uint32_t>> edgePoints_; // per edge; empty: not met yet
    std::vector<std::uint32_t> cornerPoints_;            // per corner
    std::vector<glm::dvec3> points_;
    std::vector<Face> faces_;
};

} // namespace burin
