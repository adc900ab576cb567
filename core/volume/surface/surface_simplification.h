// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/edge_collapse.h"
#include "core/volume/surface/place_table.h"
#include "core/volume/surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Joins surfaces and takes triangles out of them where they are flat enough. Keeps its working storage: one object a
/// thread.
class SurfaceSimplifier {
public:
    /// Every triangle gets one material, and points between two materials stand twice, so that colours keep their
    /// place. What borders on nothing (where the next tile begins) stays as it is, so that tiles still meet.
    /// @param tolerance how far the surface may move, mm
    /// @param cell      edge of the cells that the surface was made of, mm: triangles far larger than it decide the
    ///                  normals of their corners, so that flat faces shade flat right up to an edge
    /// @param faces     known faces of the workpiece or null: sharp edges between them are kept, and points on them
    /// stand
    ///                  once for each face, with its normal
    void simplify(SurfaceMesh& mesh, double tolerance, double cell, const KnownFaces* faces = nullptr);
    /// One mesh of several that meet: their common points are welded, but for those of sharp edges, and points that no
    /// triangle uses dropped.
    void join(std::span<const SurfaceMesh* const> pieces, SurfaceMesh& whole);
    /// Edges that have a triangle on one side only, two points each, in that triangle's turn; those that follow one
    /// another as one, where they are of one material and the points between lie within the tolerance (mm) of it.
    std::vector<std::uint32_t> rim(const SurfaceMesh& mesh, double tolerance = 0.0);

private:
    std::vector<std::uint32_t> straightened(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& edges,
                                            float tolerance);
    void weldByPlace(const SurfaceMesh& mesh);
    void chooseRegions(const SurfaceMesh& mesh, const KnownFaces* faces);
    void weldNormals(const SurfaceMesh& mesh);
    void findFacesAtPlaces(std::size_t points);
    SurfaceRegion regionOfCorner(std::size_t corner) const;
    void standByRegion(const SurfaceMesh& mesh);
    void shadeBesideEdges(SurfaceMesh& mesh);
    void takeKnownNormals(SurfaceMesh& mesh, const KnownFaces& faces);
    void leanOnFaces(SurfaceMesh& mesh, double cell);
    template <class Visit>
    void eachOpenCorner(const SurfaceMesh& mesh, Visit visit);

    EdgeCollapse collapse_;
    std::vector<SurfaceRegion> regions_;         ///< of every triangle
    std::vector<std::uint16_t> facesAt_;         ///< of every place
    std::vector<KnownFaces::Number> knownFaces_; ///< of every point of `work_`: the one whose normal it has
    std::vector<std::uint8_t> besideEdges_;      ///< of every point of `work_`: of no known face, but on a sharp edge
    PlaceTable table_;
    std::vector<std::uint32_t> placeOf_; ///< of every point: the first one at the same place
    std::vector<std::uint32_t> newPoint_, corners_;
    std::vector<glm::vec3> leaning_;
    std::vector<std::uint64_t> edges_;
    SurfaceMesh work_;
};

} // namespace burin
