// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/box.h"
#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"
#include "core/volume/runs/grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A scanline near a rapid that holds material: the rapid may touch the volume that the line represents without
/// crossing the line itself.
struct GrazedLine {
    std::uint32_t move = 0;
    LineIndex line;
};

/// The workpiece as it is known exactly: a box less the sweeps of moves.
struct ExactStock {
    Box box; ///< mm, setup frame
    /// The moves made before those that are judged, and their tools; empty: none.
    std::span<const ToolMove> movesBefore;
    std::span<const Tool> toolsBefore;
};

/// A piece offset outwards by `by` mm: contains all points within that distance, and a little more at sharp edges.
RevolvedPiece thickened(const RevolvedPiece& piece, double by) noexcept;

/// Reports rapids that touch stock by less than the scanlines show. Along upright lines, the sweep of a rapid is
/// compared with the stock less the sweeps of all moves before it, all of them exact: just inside the rapid's own
/// outline (0.01 mm) every 0.1 mm, and everywhere else at a quarter of a voxel. A touch of less than 0.01 mm is
/// ignored: posts round to a thousandth, and walls lie exactly where the moves that cut them were.
/// @param grazed in any order; the grid's runs are upright. Returns early if cancelled.
void judgeGrazes(const std::vector<GrazedLine>& grazed, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                 const Grid& grid, const ExactStock& stock, Findings& findings, const Progress& progress);

} // namespace burin
