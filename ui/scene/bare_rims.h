// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace burin {

/// Where surface tiles meet: along a side, or at a corner that four of them share. Numbers of limits count from the
/// grid's low end, along u and v.
struct TileLimit {
    enum class Kind : std::uint8_t { alongV, alongU, corner };
    Kind kind = Kind::corner;
    std::int32_t u = 0, v = 0; ///< of a limit, or of the tile beside it
    friend auto operator<=>(const TileLimit&, const TileLimit&) = default;
};

/// Tells which points of a tile's surface other tiles have as well.
class TileLimits {
public:
    /// @param cell of the surface, mm
    TileLimits(const Grid& grid, SurfaceTile tile, double cell);
    /// Nothing: inside the tile, or on the grid's own border.
    std::optional<TileLimit> at(const glm::vec3& place) const;
    /// Whether a place belongs to the tile or is no farther from it than that, mm.
    bool near(const glm::vec3& place, float distance) const;
    /// The other tiles from which a place is no farther than that, mm.
    std::vector<SurfaceTile> tilesNear(const glm::vec3& place, float distance) const;
    int axisOfRuns() const { return 3 - axisOfU_ - axisOfV_; }

private:
    /// How a place lies to the tile along u or v.
    struct Side {
        float low = 0.0F, high = 0.0F;              ///< mm
        bool lowShared = false, highShared = false; ///< another tile begins there
    };
    SurfaceTile tile_;
    int axisOfU_, axisOfV_;
    float reach_; ///< mm, of shared points from the limit
    Side u_, v_;
};

/// What is drawn of points that tiles share: whichever tile is made first decides it for all, as long as the surface at
/// such a point stays as it is.
class BareRims {
public:
    struct Point {
        glm::vec3 place{0.0F}; ///< on the workpiece's surface, mm
        PropertyIndex property = 0;
        // As it is drawn.
        glm::vec3 drawnPlace{0.0F}, drawnNormal{0.0F};
        PropertyIndex drawnProperty = 0;
        std::uint8_t around = 0; ///< what the triangles of all tiles around it are
    };
    /// Null: none is known.
    const Point* find(const TileLimit& limit, const glm::vec3& place, PropertyIndex property) const;
    /// Replaces all that is known of a limit. @param points all that the limit has now
    void set(const TileLimit& limit, std::vector<Point> points);
    void clear() { points_.clear(); }

private:
    std::map<TileLimit, std::vector<Point>> points_; ///< of each limit by place
};

} // namespace burin
