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

/// Returns the faces that bound a shape, in the order of the shape, by which ShapeMesh numbers them.
std::vector<TopoDS_Face> meshedFaces(const TopoDS_Shape& shape);

/// The triangles of a meshed shape, face by face, with vertices shared along its edges. They are welded by the
/// topology, not by distance, so that gaps of the shape stay and no new ones appear.
class ShapeMesh {
public:
    /// @param shape meshed by OpenCASCADE; must outlive this object.
    /// @param chord mm, for edges that belong to no meshed face.
    ShapeMesh(const TopoDS_Shape& shape, double chord);

    /// Returns the numbers of the faces that have no triangles.
    std::vector<std::size_t> emptyFaces() const;
    /// Returns the numbers of the faces with a triangle at an open edge.
    std::vector<std::size_t> facesAtOpenEdges() const;
    /// Returns the numbers of the faces whose triangles do not end at the edges of the face, or are folded over in its
    /// parameters. The triangles of all other faces cover their face once, without a hole. A face at an open edge that
    /// is not among them lies at a gap of the shape itself. Call before refining.
    std::vector<std::size_t> tornFaces() const;
    const TopoDS_Face& face(std::size_t number) const { return faces_[number].shape; }
    /// Triangulates a plane face anew from its boundary alone. Returns false, with nothing changed, if the face is not
    /// plane or its boundary is broken.
    bool fillPlaneFace(std::size_t face);

    /// Two faces may both have a chord between the same two corners, so that four triangles meet at one edge. Gives
    /// each such chord a point of its own in its middle; the surface stays the same.
    void partSharedChords();

    /// Refines every face until it is within the chord of its surface.
    void refine();

    /// Returns all faces in one mesh, mm, without unused points. @param faceOf unless null, receives the number of the
    /// face of each triangle
    TriangleMesh mesh(std::vector<std::uint32_t>* faceOf = nullptr) const;

private:
    struct Face {
        TopoDS_Face shape;
        FaceMesh mesh;
    };

    /// An edge of triangles, and the number of uses from its lower vertex to its higher minus those in the other
    /// direction.
    struct Border {
        std::uint64_t edge = 0;
        int balance = 0;
    };

    template <class Visit>
    static void visitEdges(const FaceMesh& mesh, Visit visit);
    /// Returns the edges where the triangles of one face end, in the order of their keys.
    static std::vector<Border> bordersOf(const FaceMesh& mesh);
    bool isTorn(const Face& face) const;
    static bool isFolded(const FaceMesh& mesh);
    void addFace(const TopoDS_Face& face);
    static void splitChord(FaceMesh& face, std::uint32_t from, std::uint32_t to, std::uint32_t middle);
    std::uint32_t vertexOf(const TopoDS_Shape& vertex);
    std::uint32_t addPoint(const glm::dvec3& point);
    void shareEdges(const TopoDS_Face& face, std::vector<std::uint32_t>& nodes);
    /// Vertices along an edge in the order of its parameter; made from the curve if no face has meshed it.
    const std::vector<std::uint32_t>& pointsAlong(const TopoDS_Shape& edge);
    std::vector<std::uint32_t> loopOf(const TopoDS_Shape& wire, const TopoDS_Face& face);

    double chord_;
    TopTools_IndexedMapOfShape edges_, corners_;
    std::vector<std::vector<std::uint32_t>> edgePoints_; // per edge; empty: not visited yet
    std::vector<std::uint32_t> cornerPoints_;            // per corner
    std::vector<glm::dvec3> points_;
    std::vector<Face> faces_;
};

} // namespace burin
