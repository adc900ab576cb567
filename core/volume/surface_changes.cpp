// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface.h"
#include "core/volume/surface_window.h"
#include "core/volume/tile.h"

#include <algorithm>

namespace burin {

std::vector<SurfaceTile> changedSurface(const VolumeSnapshot& before, const VolumeSnapshot& now, int level) {
    const Grid& grid = now.grid();
    const glm::ivec2 count = surfaceTiles(grid);
    const bool known = now.sameVolume(before);
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y),
                                      known ? 0 : 1);
    const std::int32_t reach = SurfaceWindow::margin << level;
    for (std::int32_t v = 0; known && v < grid.lineCountV(); v += tileSide)
        for (std::int32_t u = 0; u < grid.lineCountU(); u += tileSide) {
            if (now.sharesBrick(before, {u, v})) continue;
            const glm::ivec2 low = glm::max(glm::ivec2(u, v) - reach, 0) / linesPerSurfaceTile;
            const glm::ivec2 high =
                glm::min((glm::ivec2(u, v) + tileSide - 1 + reach) / linesPerSurfaceTile, count - 1);
            for (int tileV = low.y; tileV <= high.y; ++tileV)
                std::fill_n(changed.begin() + tileV * count.x + low.x, high.x - low.x + 1, std::uint8_t{1});
        }
    std::vector<SurfaceTile> tiles;
    for (int v = 0; v < count.y; ++v)
        for (int u = 0; u < count.x; ++u)
            if (changed[static_cast<std::size_t>(v * count.x + u)] != 0) tiles.push_back({u, v});
    return tiles;
}

} // namespace burin
