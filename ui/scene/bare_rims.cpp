// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bare_rims.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

constexpr double sharedReach = 0.51; // cells

std::array<float, 3> keyOf(const glm::vec3& place) {
    return {place.x, place.y, place.z};
}

} // namespace

TileLimits::TileLimits(const Grid& grid, SurfaceTile tile, double cell)
    : tile_(tile), axisOfU_(grid.axisOfU()), axisOfV_(grid.axisOfV()), reach_(static_cast<float>(sharedReach * cell)) {
    const glm::ivec2 count = surfaceTiles(grid);
    const double size = linesPerSurfaceTile * grid.edge();
    const auto sideOf = [&](std::int32_t at, int axis, int tiles) {
        const double low = grid.low()[axis] + at * size;
        return Side{static_cast<float>(low), static_cast<float>(low + size), at > 0, at + 1 < tiles};
    };
    u_ = sideOf(tile.u, axisOfU_, count.x);
    v_ = sideOf(tile.v, axisOfV_, count.y);
}

std::optional<TileLimit> TileLimits::at(const glm::vec3& place) const {
    const auto limitOf = [&](const Side& side, float along, std::int32_t number) -> std::optional<std::int32_t> {
        if (side.lowShared && along < side.low + reach_) return number;
        if (side.highShared && along > side.high - reach_) return number + 1;
        return std::nullopt;
    };
    const auto u = limitOf(u_, place[axisOfU_], tile_.u), v = limitOf(v_, place[axisOfV_], tile_.v);
    if (u && v) return TileLimit{TileLimit::Kind::corner, *u, *v};
    if (u) return TileLimit{TileLimit::Kind::alongV, *u, tile_.v};
    if (v) return TileLimit{TileLimit::Kind::alongU, tile_.u, *v};
    return std::nullopt;
}

bool TileLimits::near(const glm::vec3& place, float distance) const {
    const float u = place[axisOfU_], v = place[axisOfV_];
    return u > u_.low - distance && u < u_.high + distance && v > v_.low - distance && v < v_.high + distance;
}

std::vector<SurfaceTile> TileLimits::tilesNear(const glm::vec3& place, float distance) const {
    const auto stepsOf = [&](const Side& side, float along) {
        std::vector<std::int32_t> steps{0};
        if (side.lowShared && along < side.low + distance) steps.push_back(-1);
        if (side.highShared && along > side.high - distance) steps.push_back(1);
        return steps;
    };
    std::vector<SurfaceTile> tiles;
    for (const std::int32_t v : stepsOf(v_, place[axisOfV_]))
        for (const std::int32_t u : stepsOf(u_, place[axisOfU_]))
            if (u != 0 || v != 0) tiles.push_back({tile_.u + u, tile_.v + v});
    return tiles;
}

const BareRims::Point* BareRims::find(const TileLimit& limit, const glm::vec3& place, PropertyIndex property) const {
    const auto points = points_.find(limit);
    if (points == points_.end()) return nullptr;
    const auto same =
        std::ranges::equal_range(points->second, keyOf(place), {}, [](const Point& one) { return keyOf(one.place); });
    const auto point = std::ranges::find(same, property, &Point::property);
    return point == same.end() ? nullptr : &*point;
}

void BareRims::set(const TileLimit& limit, std::vector<Point> points) {
    std::ranges::sort(points, {}, [](const Point& one) { return keyOf(one.place); });
    points_[limit] = std::move(points);
}

} // namespace burin
