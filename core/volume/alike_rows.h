// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_box.h"

#include <cstddef>
#include <cstdint>

namespace burin {

/// Up to eight scanlines side by side in a brick, as a window sees them.
struct AlikeRow {
    const Segment* segments = nullptr;      ///< of the brick
    const std::uint32_t* offsets = nullptr; ///< where the lines begin, and the end of the last
    std::size_t count = 0;                  ///< lines
    std::uint32_t skipped = 0;              ///< segments of each before the window
    std::uint32_t low = 0, high = 0;        ///< packed: a segment ends behind low if above, before high if below
    bool opens = false;                     ///< the window begins before the grid, where all is air
    std::int32_t rounding = 0;              ///< run units: place 0 of a `SurfaceLine`
    int level = 0;
};

/// Reads the lines at once if they are alike: all of them skip so many segments, and go on with the same ones in the
/// window, which change between material and air once at most.
/// @param lines         written, one a line
/// @param firstSegments likewise: the first segment that ends within the window or behind it
/// @param seen          by property: set to 1 where one occurs
/// @param changes       what is known where they enter the window and leave it is added
/// @return false: they are not alike, or the processor has no AVX-512
bool readAlikeRow(const AlikeRow& row, SurfaceLine* lines, const Segment** firstSegments, std::uint8_t* seen,
                  SurfaceChanges& changes) noexcept;

} // namespace burin
