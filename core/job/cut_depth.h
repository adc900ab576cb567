// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/passes/workpiece_heights.h"

namespace burin {

/// mm: the deepest cut of a width in the stock, as spindle and tool bear it and the tool itself states. @param width mm
double deepestCut(const MillingContext& milling, double width);

/// The tool as planners use it in the stock: its depth of cut is no more than workshops take through the material, in
/// rows nearly as wide as the tool is, and than spindle and tool bear.
Tool plannedTool(const MillingContext& milling);

/// How high stock that can be milled stands. Nothing known where its runs are not along Z.
StandingStock seenFromAbove(const RunVolume& workpiece);

} // namespace burin
