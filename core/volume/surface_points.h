// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_field.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Where the cubes between two rows of a field lie in the setup frame.
struct SurfaceFrame {
    int stride = 0;                         ///< from column to column
    int firstU = 0, v = 0, firstNode = 0;   ///< the grid's count of column 0, of the first row, of node 0
    std::array<int, 3> axes{};              ///< x, y or z (0, 1, 2) of u, v and the runs
    std::array<float, 3> low{};             ///< mm, of the grid's first node along those
    float size = 1.0F;                      ///< mm, of a cell
    static constexpr std::size_t spare = 8; ///< room behind the points that may be written to
};

/// One point for each cube (`SurfaceCrossings`), in the middle of the crossings on its edges (Gibson 1998), and its
/// normal: downhill in the smooth field there, unit length. Places come from the grid's own counts, so that they are
/// alike in every window.
/// @param cubes   the surface crosses each; behind them so many more may be read as there is room for points
/// @param points  mm, setup frame
/// @param normals likewise
void placeSurfacePoints(const SurfaceFrame& frame, const std::array<SurfaceField::Row, 2>& rows,
                        std::span<const std::uint32_t> cubes, glm::vec3* points, glm::vec3* normals) noexcept;

} // namespace burin
