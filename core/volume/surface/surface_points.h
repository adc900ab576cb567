// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_edges.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Where the cubes of a field lie in the setup frame.
struct SurfaceFrame {
    int firstU = 0, firstV = 0, firstNode = 0; ///< grid indices of column 0, of row 0, of node 0
    /// Cubes from this column, row and node on own the edges that start at their lowest corner.
    int firstEdgeColumn = 0, firstEdgeRow = 0, firstEdgeNode = 0;
    /// Index increments from column to column of a row, and from row to row. `rowsKept` rows are distinguished.
    int stride = 0, placesPerRow = 0;
    static constexpr int rowsKept = 8;
    int axisOfRuns = 2;         ///< x, y or z: 0, 1, 2
    std::array<float, 3> low{}; ///< mm, of the grid's first node along u, v and the runs
    float size = 1.0F;          ///< mm, of a cell
    /// Number of entries behind the points that may be overwritten.
    static constexpr std::size_t spare = SurfaceBatch::spare;
};

/// Computes one point for each cube, in the middle of the crossings on its edges (Gibson 1998), and its normal:
/// downhill in the smooth field there, unit length. Positions are computed from the grid's own indices, so that they
/// are identical in every window.
/// @param points   mm, setup frame
/// @param normals  likewise
/// @param edges    receives the edges that the cubes own
void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept;
/// The same for processors without AVX-512; bit-identical, as a test verifies.
namespace any_processor {
void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept;
}

} // namespace burin
