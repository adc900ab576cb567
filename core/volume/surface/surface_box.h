// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_window.h"

#include <cstdint>
#include <span>

namespace burin {

/// Where a scanline first changes between material and air within a window. Positions are in 1/256 cell from the low
/// end of the window's first node, rounded to the nearest.
struct SurfaceLine {
    /// A node averages the share of solid within one cell to either side of its centre, which lies at half a cell: a
    /// change affects only nodes whose centre is less than this away.
    static constexpr std::int16_t cell = 256, centre = 128;
    /// Farther away than any node reaches, on either side: the position in a scanline without any change, which is all
    /// air or (-beyond) all solid.
    static constexpr std::int16_t beyond = 16'384;

    std::int16_t place = beyond;
    std::int16_t toAir = 0; ///< -1: from material to air, 0: from air to material
};

/// The part of a window that contains all of the window's own surface, with the margin needed around it: outside, all
/// nodes are air or all are solid. Two columns, two rows and one node before the first cube that may be crossed, and as
/// many behind the last.
struct SurfaceBox {
    struct Range {
        int first = 0, count = 0;
    };
    Range columns, rows, nodes;
    bool empty() const { return columns.count == 0 || rows.count == 0 || nodes.count == 0; }
};

/// What is known of all scanlines of a window together, in addition to their first changes.
struct SurfaceChanges {
    std::int16_t lowest = SurfaceLine::beyond, highest = -SurfaceLine::beyond; ///< positions of all further changes
    unsigned atBegin = 0, atEnd = 0; ///< 1: lines are air there, 2: lines are solid there, 3: both occur
    static unsigned bitOf(bool solid) noexcept { return solid ? 2 : 1; }
};

/// @param lines  row after row of scanlines, each padded to a multiple of `surfaceLineLanes` with copies of its last
///        line
SurfaceBox findSurfaceBox(const SurfaceWindow& window, const SurfaceChanges& changes,
                          std::span<const SurfaceLine> lines);
inline constexpr std::size_t surfaceLineLanes = 8;

} // namespace burin
