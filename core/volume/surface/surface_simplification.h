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

/// Joins surfaces and removes triangles where they are flat enough. Keeps its working storage: use one object per
/// thread.
class SurfaceSimplifier {
public:
    /// Every triangle gets one material, and points between two materials are duplicated, so that colours stay in
    /// place. Edges without a neighbour (where the next tile begins) stay unchanged, so that tiles still meet.
    /// @param tolerance  how far the surface may move, mm
    /// @param cell       edge of the cells that the surface was made of, mm: triangles far larger than it determine the
    ///        normals of their corners, so that flat faces are shaded flat right up to an edge
    /// @param faces      known faces of the workpiece or null: sharp edges between them are preserved, and points on
    ///        them are duplicated for each face, with its normal
    void simplify(SurfaceMesh& mesh, double tolerance, double cell, const KnownFaces* faces = nullptr);
    /// Joins several meshes that meet into one: their common points are welded, except on sharp edges, and points that
    /// no triangle uses are dropped.
    void join(std::span<const SurfaceMesh* const> pieces, SurfaceMesh& whole);
    /// Edges with a triangle on one side only, two points each, in the orientation of that triangle; consecutive edges
    /// are merged if they are of one material and the points between lie within the tolerance (mm) of the merged edge.
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
    std::vector<std::uint16_t> facesAt_;         ///< of every position
    std::vector<KnownFaces::Number> knownFaces_; ///< of every point of `work_`: the known face whose normal it has
    std::vector<std::uint8_t> besideEdges_;      ///< of every point of `work_`: on no known face, but on a sharp edge
    PlaceTable table_;
    std::vector<std::uint32_t> placeOf_; ///< of every point: the first one at the same position
    std::vector<std::uint32_t> newPoint_, corners_;
    std::vector<glm::vec3> leaning_;
    std::vector<std::uint64_t> edges_;
    SurfaceMesh work_;
};

} // namespace burin
