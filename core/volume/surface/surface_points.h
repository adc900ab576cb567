// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_edges.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Where a field's cubes lie in the setup frame.
struct SurfaceFrame {
    int firstU = 0, firstV = 0, firstNode = 0; ///< the grid's count of column 0, of row 0, of node 0
    /// Cubes from this column, row and node on own the edges that start at their lowest corner.
    int firstEdgeColumn = 0, firstEdgeRow = 0, firstEdgeNode = 0;
    /// From column to column of a row, and from row to row: places of nodes. As many rows are told apart as `rowsKept`.
    int stride = 0, placesPerRow = 0;
    static constexpr int rowsKept = 8;
    int axisOfRuns = 2;         ///< x, y or z: 0, 1, 2
    std::array<float, 3> low{}; ///< mm, of the grid's first node along u, v and the runs
    float size = 1.0F;          ///< mm, of a cell
    /// Room behind the points that may be written to.
    static constexpr std::size_t spare = SurfaceBatch::spare;
};

/// One point for each cube, in the middle of the crossings on its edges (Gibson 1998), and its normal: downhill in the
/// smooth field there, unit length. Places come from the grid's own counts, so that they are alike in every window.
/// @param points  mm, setup frame
/// @param normals likewise
/// @param edges   is given those that the cubes own
void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept;
/// The same for processors without AVX-512; to the last bit, which a test asks of it.
namespace any_processor {
void placeSurfacePoints(const SurfaceFrame& frame, const SurfaceBatch& cubes, glm::vec3* points, glm::vec3* normals,
                        SurfaceEdges& edges) noexcept;
}

} // namespace burin
