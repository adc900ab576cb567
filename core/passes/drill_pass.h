// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/upright_holes.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Whether a drill is the one for a hole: no wider than it but for `drillFit`, no more than 0.1 mm narrower.
/// @param radius of the drill, mm
bool fitsHole(double radius, const UprightHole& hole) noexcept;

/// Straight down, from above what stands there: as deep as a hole's bottom and `drilledThrough`, or as the request
/// says, and nowhere into the part. A stroke for each peck, all from above. Holes that fit the drill come from the part
/// where the request names no places; a place within a hole is drilled on its axis. The order goes from each to the
/// nearest, improved by turning parts of it round. Where nothing stands any more nothing is drilled.
/// Errors: argumentInvalid (a place without a hole and no depth, or in a hole that is narrower than the drill),
/// pathEmpty is the caller's; cancelled.
Result<PlannedPass> planDrilling(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
