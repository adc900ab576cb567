// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

#include <vector>

namespace burin {

/// A row in plan, mm.
using PlanRow = std::vector<glm::dvec2>;

/// Rows of parallel, radial, spiral and flow over a region's bounds, in the order in which they are milled.
/// @param stepOver mm, between rows, > 0
std::vector<PlanRow> rowsOf(const PassRequest& request, const PlanBounds& bounds, double stepOver);

/// The step between rows of a request: its own, or that of a scallop by a ball or the rounding of an edge, or a
/// fifteenth of the diameter. Errors: argumentInvalid (a scallop of a tool with a sharp edge, or higher than its
/// rounding).
Result<double> stepOverOf(const PassRequest& request, const Cutter& cutter);

/// Parallel, radial, spiral, flow: the tool comes straight down onto the part at every place of the rows, exact on the
/// part's triangles, with a place at every 0.2 mm at most, closer where the way between two would leave the part by
/// more than 0.002 mm. Beside the part it goes on at the lowest height, where stock is left. Neighbouring rows are
/// joined on the part. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planRows(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Engrave: along the lines at a depth below the top of the stock, in levels, never into the part.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planEngraving(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Waterline: along the part at one height after the other, the part to the right of the tool. Each place is exact on
/// the part's triangles. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planWaterlines(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
