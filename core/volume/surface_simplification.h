// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Takes triangles out of surfaces where they are flat enough. What borders on nothing (where the next tile begins) and
/// what borders on another material stays as it is, so that tiles still meet and colours keep their place. Keeps its
/// working storage: one object a thread.
class SurfaceSimplifier {
public:
    /// @param tolerance how far the surface may move, mm
    /// @param cell      edge of the cells that the surface was made of, mm: triangles far larger than it decide the
    ///                  normals of their corners, so that flat faces shade flat right up to an edge
    void simplify(SurfaceMesh& mesh, double tolerance, double cell);
    /// One mesh of several that meet, their common points welded.
    void join(std::span<const SurfaceMesh* const> pieces, SurfaceMesh& whole);
    /// Edges that have a triangle on one side only, two points each, in that triangle's turn.
    std::vector<std::uint32_t> rim(const SurfaceMesh& mesh);

private:
    void chooseMaterials(const SurfaceMesh& mesh);
    void addMaterial(const SurfaceMesh& mesh, PropertyIndex material, double tolerance);
    void findPlaces(const SurfaceMesh& mesh);
    template <class Visit>
    void eachOpenCorner(const SurfaceMesh& mesh, Visit visit);
    void leanOnFaces(SurfaceMesh& mesh, double cell);

    std::vector<PropertyIndex> materialOf_; ///< of every triangle
    std::vector<std::uint32_t> indices_, simplified_, newPoint_, source_;
    std::vector<glm::vec3> points_;
    SurfaceMesh result_;
    std::vector<std::uint32_t> placeOf_; ///< equal for points at the same place
    std::vector<std::uint64_t> edges_;
    std::vector<bool> open_; ///< places on an edge that has a triangle on one side only
    std::vector<glm::vec3> leaning_;
};

} // namespace burin
