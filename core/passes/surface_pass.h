// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/hand_finish.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/passes/surface_trace.h"

#include <vector>

namespace burin {

/// The rows of parallel, radial, spiral and flow over the bounds of a region, in milling order.
/// @param stepOver distance between rows, mm, > 0
std::vector<PlanRow> rowsOf(const PassRequest& request, const PlanBounds& bounds, double stepOver);

/// The rows of scallop: the distance between neighbours is the requested one, measured on the part, from the border of
/// the area inwards. Faces steeper than 75 degrees are left to a waterline. When cancelled, rows are missing.
/// @param stepOver mm, > 0 @param coarseness of the raster, see PassGround @param ball whether the tool has a ball end:
/// its ridges then have the same height on curved faces as on a plane
std::vector<PlanRow> scallopRows(const SurfaceTrace& trace, double stepOver, double coarseness, bool ball,
                                 Progress& progress);

/// The rows of `HandStrokes::extend`: beside the strokes of the hand, the first a step-over from them, and so on
/// outwards beyond the area, measured as those of scallop. Where rows from two strokes meet, part of a row fills the
/// gap. When cancelled, rows are missing. Parameters as scallopRows.
std::vector<PlanRow> extendedRows(const SurfaceTrace& trace, const HandFinish& hand, double stepOver, double coarseness,
                                  bool ball, Progress& progress);

/// The step-over of a request: the stated one, or the one that gives the requested scallop height with a ball or corner
/// radius, or a fifteenth of the diameter. Errors: argumentInvalid (a scallop height for a tool with a sharp edge, or
/// above its corner radius).
Result<double> stepOverOf(const PassRequest& request, const Cutter& cutter);

/// Parallel, radial, spiral, flow and scallop: rows projected onto the part by SurfaceTrace. Neighbouring rows are
/// joined along the part. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planRows(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Pencil: along the concave edges of the part, where the tool touches it at two points.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planPencil(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Rest: rows where the part is flat and contours where it is steep, both only where stock is left.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planRest(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Engrave: along the lines at a depth below the top of the stock, in levels, never into the part.
/// Errors: argumentInvalid, cancelled.
Result<PlannedPass> planEngraving(const PassRequest& request, const PassGround& ground, Progress& progress);

/// Waterline: along the part at one height after the other, with the part to the right of the tool. Each point is exact
/// on the triangles of the part. Errors: argumentInvalid, cancelled.
Result<PlannedPass> planWaterlines(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
