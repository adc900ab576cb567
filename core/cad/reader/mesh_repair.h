// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace burin {

/// The connectivity of the triangles of a mesh.
struct MeshConnection {
    std::size_t pieces = 0;        ///< connected through edges that two triangles share
    std::size_t edges = 0;         ///< all edges
    std::size_t boundaryEdges = 0; ///< used by only one triangle
};

/// Gives pieces that meet along an edge of four or more triangles vertices of their own there, so that each piece is a
/// manifold of its own. Returns the connectivity of the mesh.
MeshConnection separatePieces(TriangleMesh& mesh);

/// Turns triangles until neighbours agree within each piece, then turns each body outward; returns the number of turned
/// triangles. A closed piece that is oriented inwards and lies inside a mesh of positive volume is a void and stays.
std::size_t orientConsistently(TriangleMesh& mesh);

} // namespace burin
