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

/// What one move took away.
struct MoveCut {
    double volume = 0.0;      ///< mm³
    glm::dvec3 centroid{0.0}; ///< mm, setup frame; meaningless where the volume is 0
};

/// Who wants to know where shank or holder pass the stock that stands after a move without touching it.
struct NearWatch {
    double distance = 0.0;        ///< mm: nearer than this
    NearPasses* passes = nullptr; ///< null: nobody
};

/// Cuts the moves, in order, into a workpiece, flutes before shank and holder, and reports what must not happen:
/// removal by a rapid or with the spindle off, shank or holder in anything. All cores; the result does not depend on
/// how many. What it takes is what the moves take one by one: each is swept exactly.
/// @param tools those that ToolMove::tool counts
/// @param steps what the feed moves met, step by step, rising; null: nobody asks
/// @param exact the workpiece by formula, for rapids that graze it by less than a voxel (judgeGrazes); null: nobody
/// asks
/// @return by move. Errors: volumeOutOfMemory, cancelled.
Result<std::vector<MoveCut>> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    RunVolume& workpiece, Findings& findings, Progress& progress, NearWatch near = {},
                                    std::vector<StepCut>* steps = nullptr, const ExactStock* exact = nullptr);

} // namespace burin
