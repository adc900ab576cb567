// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <span>

namespace burin {

/// A closed substitute for a mesh that is not closed, so that every scanline crosses it an even number of times:
/// - triangles that occur twice with the same orientation count once;
/// - vertices at open edges within the tolerance of each other are merged, which closes slits;
/// - each remaining rim is closed by caps: triangles from its edges to its middle (T-junctions give caps without area).
/// Caps are not surface: they mark where a hole may end (see the rule in voxelisation.h).
class OpenMesh {
public:
    /// Cost: sorts the edges; about 1 s for a million triangles. @throws std::bad_alloc
    /// @param tolerance mm
    OpenMesh(const TriangleMesh& mesh, double tolerance);

    /// The surface, followed by the caps.
    const TriangleMesh& closed() const noexcept { return closed_; }
    std::size_t firstCap() const noexcept { return firstCap_; }
    std::size_t capCount() const noexcept { return closed_.triangles.size() - firstCap_; }
    std::size_t duplicates() const noexcept { return duplicates_; }
    std::size_t holes() const noexcept { return holes_; } ///< rims: loops of open edges

    /// Winding number of the caps around a point, that is, the contribution of the holes. Cost: linear in the caps.
    double windingOfCaps(const glm::dvec3& place) const noexcept;

private:
    void dropDuplicates();
    void mergeRims(double tolerance);
    void addCaps();

    TriangleMesh closed_;
    std::size_t firstCap_ = 0, duplicates_ = 0, holes_ = 0;
};

/// Solid angle of triangles seen from a point, divided by that of the full sphere: for a closed mesh the number of
/// times that it winds around the point, for an open one its generalised winding number (Jacobson, Kavan &
/// Sorkine-Hornung 2013). Positive where the triangles show their back side. Each triangle by the formula of Van
/// Oosterom & Strackee (1983).
double windingNumber(const TriangleMesh& mesh, std::size_t firstTriangle, const glm::dvec3& place) noexcept;

} // namespace burin
