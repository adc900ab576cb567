// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace burin {

/// A surface over a raster of points, row by row along x.
struct SurfaceRaster {
    int columns = 0, rows = 0;
    std::vector<char> on; ///< by point: whether it belongs to the surface

    std::size_t indexOf(int column, int row) const noexcept {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

/// The distance of each point of a surface from its border, measured on the surface; 0 outside it. Fast marching over
/// the triangles between neighbouring points (Kimmel and Sethian 1998), using only the lengths of their sides.
/// @param length length of the side from one point to a neighbour, by their indices, > 0
/// @param beginning distance of the points on the border
std::vector<double> distancesFromBorder(const SurfaceRaster& surface,
                                        const std::function<double(std::size_t, std::size_t)>& length,
                                        double beginning);
/// The same from given points. @param beginnings distance of each point, mm; infinite where it is to be found
std::vector<double> distancesFrom(const SurfaceRaster& surface,
                                  const std::function<double(std::size_t, std::size_t)>& length,
                                  const std::vector<double>& beginnings);

} // namespace burin
