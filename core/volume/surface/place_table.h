// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/place_hash.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Finds equal points by a hash of their position. Keeps its storage from use to use.
class PlaceTable {
public:
    /// Empties the table. @param points  maximum number of entries
    void open(std::size_t points) { slots_.assign(std::bit_ceil(2 * points + 1), none); }

    /// Returns the first entered point that is equal to this one, which is entered if there is none.
    /// @param equal  whether another point, at a position with the same hash, is equal to this one
    template <class Equal>
    std::uint32_t entry(std::span<const glm::vec3> points, std::uint32_t point, Equal equal) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = PlaceHash{}(points[point]) & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == none) slots_[slot] = point;
            if (slots_[slot] == point || equal(slots_[slot])) return slots_[slot];
        }
    }

    /// Returns for each point the first one at the same position.
    /// @param placeOf replaced
    void weld(std::span<const glm::vec3> points, std::vector<std::uint32_t>& placeOf) {
        open(points.size());
        placeOf.resize(points.size());
        for (std::uint32_t point = 0; point < points.size(); ++point)
            placeOf[point] = entry(points, point, [&](std::uint32_t other) { return points[other] == points[point]; });
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> slots_;
};

} // namespace burin
