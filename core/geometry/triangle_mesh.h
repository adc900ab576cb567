// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Triangles with shared vertices, mm. Counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into `vertices`

    bool empty() const noexcept { return triangles.empty(); }
};

inline Triangle cornersOf(const TriangleMesh& mesh, std::size_t triangle) noexcept {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Bounding box of the vertices that triangles use; empty for an empty mesh.
Box boundingBox(const TriangleMesh& mesh);

/// Enclosed volume, mm³, by the divergence theorem; positive for outward normals. Meaningless for an open mesh.
double signedVolume(const TriangleMesh& mesh);

/// Area, mm².
double surfaceArea(const TriangleMesh& mesh);

/// For each vertex the first vertex that is bit-identical to it (itself if there is no earlier one).
std::vector<std::uint32_t> firstAtSamePlace(const TriangleMesh& mesh);

/// Merges vertices that are bit-identical and drops triangles that collapse as a result. The order of triangles is
/// kept.
TriangleMesh weldIdenticalVertices(const TriangleMesh& mesh);

/// Number of undirected edges that are not used by exactly two triangles with opposite directions. 0: closed, manifold
/// and consistently oriented.
std::size_t countOpenEdges(const TriangleMesh& mesh);

/// `mesh` followed by `other`, vertices not merged.
void append(TriangleMesh& mesh, const TriangleMesh& other);

} // namespace burin
