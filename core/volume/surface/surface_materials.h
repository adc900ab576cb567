// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_lines.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Finds the material under the points of a window's surface: the part if it lies within a voxel (a finishing pass
/// leaves a film of some hundredths of a millimetre, which should not be shown as stock), otherwise the first material
/// that is not air on the way inwards. A coarse surface may lie correspondingly farther out. Keeps its working storage.
class SurfaceMaterials {
public:
    /// @param lines    of the window, from the same workpiece
    /// @param points   mm, setup frame; `spare` more may be read behind them
    /// @param normals  likewise
    /// @param properties  one per point, output
    void find(const VolumeSnapshot& workpiece, const SurfaceWindow& window, const SurfaceLines& lines,
              std::span<const glm::vec3> points, const glm::vec3* normals, PropertyIndex* properties);
    static constexpr std::size_t spare = 8;

    /// A position in a window: the scanline, as `SurfaceLines::Materials` counts, and the position along it, run units.
    struct Place {
        std::int32_t line = 0, position = 0;
    };
    /// Converts millimetres into such positions; by u, v and the runs.
    struct Frame {
        int axisOfRuns = 2;                  ///< x, y or z: 0, 1, 2
        std::array<float, 3> low{};          ///< mm, of the grid
        float perMillimetre = 1.0F;          ///< voxels
        std::array<std::int32_t, 2> first{}; ///< the window's first scanline
        std::array<std::int32_t, 3> count{}; ///< scanlines of the grid; run units of a scanline
        std::int32_t step = 0;               ///< from a scanline of the window to the next along v
    };

private:
    PropertyIndex search(const SurfaceLines& lines, std::span<const glm::vec3> point, const glm::vec3* normal,
                         std::span<const float> depths) const;

    Frame frame_;
    std::array<std::vector<Place>, 3> places_; ///< by depth
};

} // namespace burin
