// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/surface_trace.h"

#include <vector>

namespace burin {

/// The lines along which a tip goes where the tool lies on the part in two places whose faces meet at more than 20
/// degrees: where a larger cutter, or one that goes across, leaves stock in concave edges. A place of a line is on the
/// edge within 0.001 mm, on the side that is free, and no chord leaves it by more than 0.002 mm where the edge goes on
/// evenly. Edges that are less than a square of the raster apart are found as one. All cores; cancelled, some lines are
/// missing. @param raster mm, of the squares that are looked at, > 0
std::vector<TipLine> creaseLines(const SurfaceTrace& trace, double raster, Progress& progress);

} // namespace burin
