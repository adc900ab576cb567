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

/// A scanline near a rapid in which something stands: the rapid may touch what the line stands for without meeting the
/// line itself.
struct GrazedLine {
    std::uint32_t move = 0;
    LineIndex line;
};

/// The workpiece as it is known exactly: a box, less what moves swept.
struct ExactStock {
    Box box; ///< mm, setup frame
    /// What was milled before the moves that are judged, and with what; empty: nothing.
    std::span<const ToolMove> movesBefore;
    std::span<const Tool> toolsBefore;
};

/// A piece moved outwards by some mm: all that is no farther from it, and at sharp edges a little more.
RevolvedPiece thickened(const RevolvedPiece& piece, double by) noexcept;

/// Rapids that touch stock by less than scanlines tell. Along upright lines as close as need be, a rapid's sweep is
/// held against the stock less the sweeps of all moves before it, each exact: inside of the rapid's own outline
/// (0.01 mm), every 0.1 mm, and all over at a quarter of a voxel. A touch of less than 0.01 mm is none: posts round to
/// a thousandth, and walls are where the moves that cut them were.
/// @param grazed any order; the grid's runs are upright. Ends early where it is cancelled.
void judgeGrazes(const std::vector<GrazedLine>& grazed, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                 const Grid& grid, const ExactStock& stock, Findings& findings, const Progress& progress);

} // namespace burin
