// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/near_pass.h"
#include "core/verify/rapid_graze.h"
#include "core/verify/step_meter.h"
#include "core/verify/tool_moves.h"

#include <span>
#include <vector>

namespace burin {

/// The material that one move removed.
struct MoveCut {
    double volume = 0.0;      ///< mm³
    glm::dvec3 centroid{0.0}; ///< mm, setup frame; meaningless where the volume is 0
};

/// A request for near passes: where shank or holder pass the stock that stands after a move without touching it.
struct NearWatch {
    double distance = 0.0;        ///< mm: passes closer than this are reported
    NearPasses* passes = nullptr; ///< null: not requested
};

/// Cuts the moves, in order, into a workpiece, flutes before shank and holder, and reports what must not happen:
/// removal by a rapid, with the spindle off, or with the spindle on by a tool that doesn't turn, and contact of shank
/// or holder with anything. Uses all cores; the result does not depend on their number. Each move is swept exactly (a
/// tool that doesn't turn: as SolidColumns does), so that the result is that of the moves made one by one.
/// @param tools indexed by ToolMove::tool
/// @param steps receives what the feed moves met, step by step, in ascending order; null: not requested
/// @param exact the exact workpiece, for rapids that graze it by less than a voxel (judgeGrazes); null: not requested
/// @return by move.
/// Errors: volumeOutOfMemory, cancelled.
Result<std::vector<MoveCut>> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    RunVolume& workpiece, Findings& findings, Progress& progress, NearWatch near = {},
                                    std::vector<StepCut>* steps = nullptr, const ExactStock* exact = nullptr);

class KeptRows;

/// What a replay removed and left.
struct MachinedWorkpiece {
    std::vector<MoveCut> cuts; ///< by move
    RunVolume workpiece;
};

/// The same from a fresh workpiece that stays as it is. Rows of bricks that the same moves come near as in the last
/// replay are not cut again: the result is that of a replay of all rows, bit for bit.
/// @param numbers of the moves (KnownMoves)
/// @param kept  of replays from the same fresh workpiece with the same tools and distance, steps and grazes requested
///        as now; gets what this one did in the end
/// Errors: outOfMemory, volumeOutOfMemory, cancelled.
Result<MachinedWorkpiece> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                 const RunVolume& fresh, KeptRows& kept, std::span<const std::uint32_t> numbers,
                                 Findings& findings, Progress& progress, NearWatch near = {},
                                 std::vector<StepCut>* steps = nullptr, const ExactStock* exact = nullptr);

} // namespace burin
