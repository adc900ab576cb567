// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace burin {

/// How the triangles of a mesh hang together.
struct MeshConnection {
    std::size_t pieces = 0;        ///< connected over edges that two triangles share
    std::size_t edges = 0;         ///< all
    std::size_t boundaryEdges = 0; ///< used by one triangle alone
};

/// Pieces that meet along an edge of four or more triangles get vertices of their own there, so that each is a manifold
/// for itself. Answers how the mesh hangs together.
MeshConnection separatePieces(TriangleMesh& mesh);

/// Turns triangles until neighbours agree within each piece, then each body outward; answers how many were turned.
/// A piece that closes on itself and lies inside out within a whole of positive volume is a void and stays.
std::size_t orientConsistently(TriangleMesh& mesh);

} // namespace burin
