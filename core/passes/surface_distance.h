// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace burin {

/// A surface over a raster of places, row by row along x.
struct SurfaceRaster {
    int columns = 0, rows = 0;
    std::vector<char> on; ///< by place: it belongs to the surface

    std::size_t indexOf(int column, int row) const noexcept {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

/// How far each place of a surface is from its border, on the surface; 0 beside it. Fast marching over the triangles
/// between neighbouring places (Kimmel and Sethian 1998), in lengths of their sides alone.
/// @param length of the side from one place to a neighbour, by their indices, > 0
/// @param beginning of the places on the border
std::vector<double> distancesFromBorder(const SurfaceRaster& surface,
                                        const std::function<double(std::size_t, std::size_t)>& length,
                                        double beginning);

} // namespace burin
