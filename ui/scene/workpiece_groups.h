// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// Square groups of a workpiece's surface tiles, each drawn by one actor, because every actor has a cost, however
/// little it draws.
class WorkpieceGroups {
public:
    WorkpieceGroups() = default;
    explicit WorkpieceGroups(const Grid& grid) : tiles_(surfaceTiles(grid)) {
        side_ = std::max(smallestSide, (std::max(tiles_.x, tiles_.y) + mostPerSide - 1) / mostPerSide);
        groups_ = (tiles_ + side_ - 1) / side_;
        for (int v = 0; v < groups_.y; ++v)
            for (int u = 0; u < groups_.x; ++u) centres_.push_back(centre(grid, {u, v}));
    }

    std::size_t count() const { return centres_.size(); }
    std::size_t tileCount() const { return static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y); }
    /// The centre of each group's part of the grid, mm, setup frame.
    const std::vector<glm::dvec3>& centres() const { return centres_; }
    std::size_t place(SurfaceTile tile) const { return static_cast<std::size_t>(tile.v * tiles_.x + tile.u); }
    std::size_t groupOf(SurfaceTile tile) const {
        return static_cast<std::size_t>(tile.v / side_ * groups_.x + tile.u / side_);
    }
    template <class Visit>
    void eachTile(std::size_t group, Visit visit) const {
        const int u = static_cast<int>(group) % groups_.x * side_, v = static_cast<int>(group) / groups_.x * side_;
        for (int tileV = v; tileV < std::min(v + side_, tiles_.y); ++tileV)
            for (int tileU = u; tileU < std::min(u + side_, tiles_.x); ++tileU) visit(SurfaceTile{tileU, tileV});
    }

private:
    static constexpr int smallestSide = 4, mostPerSide = 6;

    glm::dvec3 centre(const Grid& grid, glm::ivec2 group) const {
        const double size = side_ * linesPerSurfaceTile * grid.edge();
        glm::dvec3 place = grid.box().centre();
        place[grid.axisOfU()] = grid.low()[grid.axisOfU()] + (group.x + 0.5) * size;
        place[grid.axisOfV()] = grid.low()[grid.axisOfV()] + (group.y + 0.5) * size;
        return place;
    }

    glm::ivec2 tiles_{0}, groups_{0};
    int side_ = 1; ///< tiles
    std::vector<glm::dvec3> centres_;
};

} // namespace burin
