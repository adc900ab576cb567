// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cmath>
#include <cstdint>

namespace burin {

/// A box of tips divided into cubes, the tiles of a GrowingField, starting at its low corner; those at its high faces
/// are cut off there. Tiles are numbered, x running fastest. mm.
struct TileLayout {
    Box tips;
    double edge = 1.0;    ///< of a tile
    double perEdge = 1.0; ///< its reciprocal, for look-ups
    glm::ivec3 tiles{1};

    TileLayout() = default;
    TileLayout(const Box& box, double tileEdge) noexcept : tips(box), edge(tileEdge), perEdge(1.0 / tileEdge) {
        for (int axis = 0; axis < 3; ++axis)
            tiles[axis] = std::max(1, static_cast<int>(std::ceil((box.high[axis] - box.low[axis]) / edge - 1e-9)));
    }
    std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(tiles.x * tiles.y * tiles.z); }
    glm::ivec3 placeOf(std::uint32_t tile) const noexcept {
        const int number = static_cast<int>(tile);
        return {number % tiles.x, number / tiles.x % tiles.y, number / tiles.x / tiles.y};
    }
    std::uint32_t tileAt(const glm::ivec3& place) const noexcept {
        return static_cast<std::uint32_t>(place.x + tiles.x * (place.y + tiles.y * place.z));
    }
    /// @param tip in the box
    std::uint32_t tileOf(const glm::dvec3& tip) const noexcept {
        return tileAt(glm::clamp(glm::ivec3((tip - tips.low) * perEdge), glm::ivec3(0), tiles - 1));
    }
    Box boxOf(std::uint32_t tile) const noexcept {
        const glm::ivec3 place = placeOf(tile);
        return {tips.low + edge * glm::dvec3(place), glm::min(tips.low + edge * glm::dvec3(place + 1), tips.high)};
    }
    /// The nearest point of the box; a coordinate that is not a number becomes the low end.
    glm::dvec3 kept(const glm::dvec3& tip) const noexcept {
        glm::dvec3 nearest;
        for (int axis = 0; axis < 3; ++axis) {
            const double wanted = tip[axis], low = tips.low[axis], high = tips.high[axis];
            nearest[axis] = wanted > low ? (wanted < high ? wanted : high) : low;
        }
        return nearest;
    }
    /// Distance from a tip to the nearest point of a tile.
    double distance(std::uint32_t tile, const glm::dvec3& tip) const noexcept {
        const Box box = boxOf(tile);
        return glm::length(tip - glm::clamp(tip, box.low, box.high));
    }
};

} // namespace burin
