// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/upright_holes.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Whether a drill fits a hole: it is wider than the hole by no more than `drillFit` and narrower by no more than 0.1
/// mm.
/// @param radius radius of the drill, mm
bool fitsHole(double radius, const UprightHole& hole) noexcept;

/// Plans drilling straight down, starting above the standing stock: as deep as the bottom of a hole plus
/// `drilledThrough`, or as the request says, but never into the part. Each peck is a stroke of its own that starts
/// above the stock. If the request names no points, all holes of the part that fit the drill are drilled; a requested
/// point inside a hole is moved to the axis of the hole. The holes are ordered by nearest neighbour, improved by
/// reversing parts of the sequence. Holes without remaining stock are left out.
/// Errors: argumentInvalid (a point without a hole and without a depth, or in a hole that is narrower than the drill),
/// cancelled; pathEmpty is left to the caller.
Result<PlannedPass> planDrilling(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
