// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_batch.h"

#include "core/volume/surface/surface_cubes.h"

#include <algorithm>
#include <cstring>

namespace burin {

namespace {

using FourWords = std::uint32_t __attribute__((vector_size(16)));

/// Assembled in one register: storing single words would take as long as all other work for a cube.
void keep(const std::int16_t* low, const std::int16_t* high, std::size_t place, std::size_t next,
          std::uint32_t (&to)[4]) noexcept {
    const auto pairAt = [](const std::int16_t* nodes) noexcept {
        std::uint32_t pair;
        std::memcpy(&pair, nodes, sizeof pair);
        return pair;
    };
    const FourWords pairs{pairAt(low + place), pairAt(low + next), pairAt(high + place), pairAt(high + next)};
    std::memcpy(&to, &pairs, sizeof to);
}

} // namespace

std::span<const std::uint32_t> SurfaceBatch::add(std::span<const std::uint32_t> cubes, const Row& row,
                                                 std::uint32_t* pointAt, std::uint32_t point) noexcept {
    const std::size_t count = std::min(cubes.size(), most - count_);
    // Values that the stores can't change, as far as the compiler knows.
    const std::int16_t *const lowValues = row.field[0].values, *const highValues = row.field[1].values,
                              *const lowSmooth = row.field[0].smooth, *const highSmooth = row.field[1].smooth;
    const auto stride = static_cast<std::size_t>(row.stride);
    const std::uint32_t ofRow = row.number << rowShift;
    std::uint32_t* const kept = &cubes_[count_];
    Corners* const corners = &corners_[count_];
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = SurfaceCubes::placeOf(cubes[i]), next = place + stride;
        pointAt[place] = point + static_cast<std::uint32_t>(i);
        kept[i] = cubes[i] | ofRow;
        keep(lowValues, highValues, place, next, corners[i].values);
        keep(lowSmooth, highSmooth, place, next, corners[i].smooth);
    }
    count_ += count;
    return cubes.subspan(count);
}

} // namespace burin
