// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_box.h"

#include <cstddef>
#include <cstdint>

namespace burin {

/// Some rows of a brick, of each up to eight scanlines side by side, as a window sees them.
struct AlikeRows {
    const Segment* segments = nullptr; ///< of the brick
    const std::uint32_t* offsets =
        nullptr;                     ///< where the lines of the first row begin; the next row's are `tileSide` on
    std::size_t lines = 0, rows = 0; ///< of a row; how many
    std::uint32_t low = 0, high = 0; ///< packed: a segment ends behind low if above, before high if below
    bool opens = false;              ///< the window begins before the grid, where all is air
    std::int32_t rounding = 0;       ///< run units: place 0 of a `SurfaceLine`
    int level = 0;
};

/// Where rows that were read are kept, `step` from row to row.
struct ReadRows {
    SurfaceLine* lines = nullptr;
    const Segment** firstSegments = nullptr; ///< the first that ends within the window or behind it
    std::size_t step = 0;
    std::uint8_t* seen = nullptr; ///< by property: set to 1 where one occurs
};

/// Reads rows whose lines are alike at once: all of a row skip so many segments, and go on with the same up to three in
/// the window, which change between material and air once at most.
/// @param skipped segments of each line before the window
/// @param changes what is known where lines enter the window and leave it is added
/// @return how many rows it read: up to one that is not like that; none without AVX-512
std::size_t readAlikeRows(const AlikeRows& rows, std::uint32_t skipped, const ReadRows& to,
                          SurfaceChanges& changes) noexcept;

} // namespace burin
