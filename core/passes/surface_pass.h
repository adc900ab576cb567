// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/passes/surface_trace.h"

#include <vector>

namespace burin {

/// Rows of parallel, radial, spiral and flow over a region's bounds, in the order in which they are milled.
/// @param stepOver mm, between rows, > 0
std::vector<PlanRow> rowsOf(const PassRequest& request, const PlanBounds& bounds, double stepOver);

/// Rows of scallop: each as far from the one before as asked, measured on the part, from the border of the area
/// inwards. What is steeper than 75 degrees is left to a waterline. Cancelled, rows are missing.
/// @param stepOver mm, > 0 @param coarseness of the raster, see PassGround @param ball the tool ends in one: ridges are
/// as high on curved faces as on a plane
std::vector<PlanRow> scallopRows(const SurfaceTrace& trace, double stepOver, double coarseness, bool ball,
                                 Progress& progress);

/// The step between rows of a request: its own, or that of a scallop by a ball or the rounding of an edge, or a
/// fifteenth of the diameter. Errors: argumentInvalid (a scallop of a tool with a sharp edge, or higher than its
/// rounding).
Result<double> stepOverOf(const PassRequest& request, const Cutter& cutter);

/// Parallel, radial, spiral, flow and scallop: rows as SurfaceTrace lays them. Neighbouring rows are joined on the
/// part. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planRows(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Pencil: along the concave edges of the part, where the tool touches it in two places.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planPencil(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Rest: rows where the part is flat and contours where it is steep, both only where stock is left.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planRest(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Engrave: along the lines at a depth below the top of the stock, in levels, never into the part.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planEngraving(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Waterline: along the part at one height after the other, the part to the right of the tool. Each place is exact on
/// the part's triangles. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planWaterlines(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
