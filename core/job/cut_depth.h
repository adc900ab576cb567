// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/passes/workpiece_heights.h"

namespace burin {

/// Returns the largest depth of cut for a width of cut in the stock, mm: limited by what spindle and tool withstand and
/// by the tool's own maximum. @param width mm
double deepestCut(const MillingContext& milling, double width);

/// Returns the tool as planners use it in the stock: its depth of cut is limited to workshop practice for the material,
/// in rows nearly as wide as the tool, and to what spindle and tool withstand.
Tool plannedTool(const MillingContext& milling);

/// Steps of passes that clear stock in levels, where their request states none. mm
struct ClearingSteps {
    double stepOver = 0.0;   ///< between loops
    double levelDepth = 0.0; ///< between levels
};
/// Returns the steps that the tool's preset for the stock states, levels no deeper than plannedTool allows. Without
/// them the loops are a share of the diameter apart, and the levels as deep as plannedTool allows.
ClearingSteps clearingSteps(const MillingContext& milling);

/// Returns the height map of the machinable stock. Unknown if the runs are not parallel to Z.
StandingStock seenFromAbove(const RunVolume& workpiece);

} // namespace burin
