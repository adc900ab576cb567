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

/// Returns the height map of the machinable stock. Unknown if the runs are not parallel to Z.
StandingStock seenFromAbove(const RunVolume& workpiece);

} // namespace burin
