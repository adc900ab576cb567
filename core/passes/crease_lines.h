// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/surface_trace.h"

#include <vector>

namespace burin {

/// The tip paths along the concave edges of the part: the positions at which the tool touches the part at two points
/// whose faces meet at more than 20 degrees. A larger cutter, or one that crosses the edge, leaves stock there. Each
/// point of a line is within 0.001 mm of the edge, on the free side; where the edge is smooth, no chord deviates from
/// it by more than 0.002 mm. Edges closer together than one square of the raster are found as one. Uses all cores. When
/// cancelled, lines are missing.
/// @param raster edge of the squares that are examined, mm, > 0
std::vector<TipLine> creaseLines(const SurfaceTrace& trace, double raster, Progress& progress);

} // namespace burin
