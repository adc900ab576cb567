// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/grid.h"

#include <cstdint>
#include <span>

namespace burin {

/// Determines, 64 scanlines at a time, which of them upright flutes on a straight move may cut: compares a lower bound
/// of the height that the flutes reach with the top of the stock. Never leaves out a line that is cut, but may include
/// lines that are not. The tool's axis is parallel to the runs. The bound is for a ball of a radius larger by 0.02
/// voxel, exact along the move unless that is steeper than 4 : 1; for a bull nose or flat end with the lowest height of
/// its tip near the line; any other form counts as a flat end of the same width. All are lowered by 4 run units, which
/// is more than the error of single precision on moves of up to 10,000 voxels.
class CutFilter {
public:
    /// @param flutes flutePieces(cutter)
    CutFilter(std::span<const RevolvedPiece> flutes, const Grid& grid) noexcept;

    /// A move across the lines: lengths in voxels, heights in run units.
    struct Way {
        double fromX = 0.0, fromY = 0.0;    ///< of the tip at the start; lines are at whole numbers
        float alongX = 1.0F, alongY = 0.0F; ///< unit vector of the move across the lines
        float length = 0.0F;                ///< across the lines
        float height = 0.0F;                ///< of the tip at the start
        float slope = 0.0F, sine = 0.0F;    ///< units per voxel; of the angle
    };
    /// @param from, to tips, mm, line frame
    Way way(const glm::dvec3& from, const glm::dvec3& to) const noexcept;

    /// Bit 8 v + u is set if the line at `corner` + (u, v) may be cut.
    /// @param tops   tops of the stock in run units, line by line, u increasing; 8 rows
    /// @param stride from row to row
    std::uint64_t mayCut(const Way& way, LineIndex corner, const std::int32_t* tops, std::size_t stride) const noexcept;

private:
    Grid grid_;
    bool ball_ = false;
    float radius_ = 0.0F, flat_ = 0.0F, corner_ = 0.0F; ///< voxels
};

} // namespace burin
