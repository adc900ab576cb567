// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/grid.h"

#include <cstdint>
#include <span>

namespace burin {

/// Tells, 64 scanlines at a time, which of them upright flutes on a straight move may cut: a lower bound of the height
/// that they come down to, against the top of the stock. Never leaves out a line that is cut; names some that are not.
/// The tool's axis lies along the runs. Bound: a ball that is wider by 0.02 voxel, exact on its way but for ways
/// steeper than 4 : 1; a bull nose or a flat with the lowest height that its tip has near the line; any other form as a
/// flat as wide as it. All less 4 run units, which is more than single precision can be off on ways of up to 10,000
/// voxels.
class CutFilter {
public:
    /// @param flutes flutePieces(cutter)
    CutFilter(std::span<const RevolvedPiece> flutes, const Grid& grid) noexcept;

    /// One way among the lines: lengths in voxels, heights in run units.
    struct Way {
        double fromX = 0.0, fromY = 0.0;    ///< of the tip at the start; a line is where both are whole
        float alongX = 1.0F, alongY = 0.0F; ///< unit, of the way across the lines
        float length = 0.0F;                ///< across the lines
        float height = 0.0F;                ///< of the tip at the start
        float slope = 0.0F, sine = 0.0F;    ///< units a voxel; of the angle
    };
    /// @param from, to tips, mm, line frame
    Way way(const glm::dvec3& from, const glm::dvec3& to) const noexcept;

    /// Bit 8 v + u: the line at `corner` + (u, v) may be cut.
    /// @param tops   of the stock in run units, line by line, u rising; of 8 rows
    /// @param stride from row to row
    std::uint64_t mayCut(const Way& way, LineIndex corner, const std::int32_t* tops, std::size_t stride) const noexcept;

private:
    Grid grid_;
    bool ball_ = false;
    float radius_ = 0.0F, flat_ = 0.0F, corner_ = 0.0F; ///< voxels
};

} // namespace burin
