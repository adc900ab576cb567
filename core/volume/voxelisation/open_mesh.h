// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <span>

namespace burin {

/// What stands in for a mesh that is not closed, for a scanline to be crossed an even number of times always:
/// - triangles that are there twice, turned alike, count once;
/// - vertices at open edges that lie within the tolerance of each other become one: slits close;
/// - each rim that is left is closed by caps: triangles from its edges to the middle of them (T-junctions give caps
///   without area). Caps are no surface: they say where a hole may end (voxelisation.h has the rule).
class OpenMesh {
public:
    /// Cost: sorts the edges; about 1 s for a million triangles. @throws std::bad_alloc
    /// @param tolerance mm
    OpenMesh(const TriangleMesh& mesh, double tolerance);

    /// The surface, then the caps.
    const TriangleMesh& closed() const noexcept { return closed_; }
    std::size_t firstCap() const noexcept { return firstCap_; }
    std::size_t capCount() const noexcept { return closed_.triangles.size() - firstCap_; }
    std::size_t duplicates() const noexcept { return duplicates_; }
    std::size_t holes() const noexcept { return holes_; } ///< rims: loops of open edges

    /// Winding number of the caps around a place: what the holes make of it. Cost: linear in the caps.
    double windingOfCaps(const glm::dvec3& place) const noexcept;

private:
    void dropDuplicates();
    void mergeRims(double tolerance);
    void addCaps();

    TriangleMesh closed_;
    std::size_t firstCap_ = 0, duplicates_ = 0, holes_ = 0;
};

/// Solid angle of triangles seen from a place over that of the whole sphere: for a closed mesh how often it winds
/// around it, for an open one its generalised winding number (Jacobson, Kavan & Sorkine-Hornung 2013). Positive where
/// the triangles show their back. Each triangle by the formula of Van Oosterom & Strackee (1983).
double windingNumber(const TriangleMesh& mesh, std::size_t firstTriangle, const glm::dvec3& place) noexcept;

} // namespace burin
