// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/recording/generated_moves.h"

namespace burin {

/// Plans a pass of any kind. Any thread; the work is shared among all cores, the result does not depend on them.
/// Errors: those of validate, checkPlannable and of the kind's planner (level_pass.h, surface_pass.h, drill_pass.h);
/// notSupported (a drill for another pass than drilling, or the other way round); cancelled.
Result<PlannedPass> planPass(const PassRequest& request, const PassGround& ground, Progress& progress);

/// mm, of its strokes.
double lengthOf(const PlannedPass& planned) noexcept;

/// A planned pass as a source of paths. Moments count its places. @param info but for id and count of points
GeneratedMoves movesOf(const PlannedPass& planned, GeneratedInfo info);

} // namespace burin
