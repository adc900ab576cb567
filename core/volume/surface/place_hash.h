// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace burin {

/// Hash of a position, for tables of points that are equal bit for bit.
struct PlaceHash {
    std::size_t operator()(const glm::vec3& place) const noexcept {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis)
            hash = (hash ^ std::bit_cast<std::uint32_t>(place[axis] + 0.0F)) * 0x9e3779b97f4a7c15U; // + 0: -0 is 0
        return static_cast<std::size_t>(hash >> 20);
    }
};

} // namespace burin
