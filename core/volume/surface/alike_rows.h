// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_box.h"

#include <cstddef>
#include <cstdint>

namespace burin {

/// Some rows of a brick, each of up to eight scanlines side by side, as seen by a window.
struct AlikeRows {
    const Segment* segments = nullptr; ///< of the brick
    const std::uint32_t* offsets =
        nullptr;                     ///< where the lines of the first row begin; the next row's are `tileSide` on
    std::size_t lines = 0, rows = 0; ///< lines per row; number of rows
    std::uint32_t low = 0, high = 0; ///< packed bounds: a segment ends behind low if greater, before high if less
    bool opens = false;              ///< the window begins before the grid, where everything is air
    std::int32_t rounding = 0;       ///< run units: position 0 of a `SurfaceLine`
    int level = 0;
};

/// Destination of the rows that were read, `step` apart.
struct ReadRows {
    SurfaceLine* lines = nullptr;
    const Segment** firstSegments = nullptr; ///< the first that ends within the window or behind it
    std::size_t step = 0;
    std::uint8_t* seen = nullptr; ///< by property: set to 1 for each that occurs
};

/// Reads rows whose lines are alike all at once: all lines of a row skip the same number of segments and continue with
/// the same segments, up to three, in the window, which change between material and air at most once.
/// @param skipped segments of each line before the window
/// @param changes  what is known where lines enter and leave the window is added to it
/// @return number of rows read, up to one that is not like that; 0 without AVX-512
std::size_t readAlikeRows(const AlikeRows& rows, std::uint32_t skipped, const ReadRows& to,
                          SurfaceChanges& changes) noexcept;

} // namespace burin
