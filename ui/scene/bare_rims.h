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

/// Where surface tiles meet: along a side, or at a corner shared by four of them. Limits are numbered from the grid's
/// low end, along u and v.
struct TileLimit {
    enum class Kind : std::uint8_t { alongV, alongU, corner };
    Kind kind = Kind::corner;
    std::int32_t u = 0, v = 0; ///< number of a limit, or of the tile next to it
    friend auto operator<=>(const TileLimit&, const TileLimit&) = default;
};

/// Determines which points of a tile's surface are shared with other tiles.
class TileLimits {
public:
    /// @param cell of the surface, mm
    TileLimits(const Grid& grid, SurfaceTile tile, double cell);
    /// std::nullopt inside the tile and on the grid's own border.
    std::optional<TileLimit> at(const glm::vec3& place) const;
    /// Whether a point is in the tile or no farther from it than `distance`, mm.
    bool near(const glm::vec3& place, float distance) const;
    /// The other tiles from which a point is no farther than `distance`, mm.
    std::vector<SurfaceTile> tilesNear(const glm::vec3& place, float distance) const;
    int axisOfRuns() const { return 3 - axisOfU_ - axisOfV_; }

private:
    /// The limits of the tile along u or v.
    struct Side {
        float low = 0.0F, high = 0.0F;              ///< mm
        bool lowShared = false, highShared = false; ///< whether another tile begins there
    };
    SurfaceTile tile_;
    int axisOfU_, axisOfV_;
    float reach_; ///< mm, maximum distance of shared points from the limit
    Side u_, v_;
};

/// How points that are shared by tiles are drawn: the tile that is made first decides for all, as long as the surface
/// at such a point doesn't change.
class BareRims {
public:
    struct Point {
        glm::vec3 place{0.0F}; ///< on the workpiece's surface, mm
        PropertyIndex property = 0;
        // As the point is drawn.
        glm::vec3 drawnPlace{0.0F}, drawnNormal{0.0F};
        PropertyIndex drawnProperty = 0;
        std::uint8_t around = 0; ///< the kinds of the triangles of all tiles around it
    };
    /// Null if no such point is known.
    const Point* find(const TileLimit& limit, const glm::vec3& place, PropertyIndex property) const;
    /// Replaces all points known for a limit. @param points all current points of the limit
    void set(const TileLimit& limit, std::vector<Point> points);
    void clear() { points_.clear(); }

private:
    std::map<TileLimit, std::vector<Point>> points_; ///< of each limit, sorted by position
};

} // namespace burin
