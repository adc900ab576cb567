// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/recording/generated_moves.h"

namespace burin {

/// Whether a kind of pass is offered for a tool: each tool drills, mills threads, or does all the rest.
bool mayPlan(PassKind kind, const Tool& tool);

/// Whether a tool's passes need the clearance field: what works in holes alone asks the part itself.
bool needsField(const Tool& tool);

/// Whether a pass can be planned with a tool, as far as they alone show it: asked before the stock and the field, which
/// take seconds, are prepared.
/// Errors: those of validate and checkPlannable; notSupported (a drill for another pass than drilling, drilling with
/// another tool, or a tool that doesn't turn).
Result<void> checkPass(const PassRequest& request, const Tool& tool);

/// Plans a pass of any kind. Thread-safe. The work is shared among all cores; the result does not depend on their
/// number.
/// Errors: those of checkPass and the planner of the kind (level_pass.h, surface_pass.h, drill_pass.h, thread_pass.h);
/// cancelled.
Result<PlannedPass> planPass(const PassRequest& request, const PassGround& ground, Progress& progress);

/// The length of its strokes, mm.
double lengthOf(const PlannedPass& planned) noexcept;

/// Converts a planned pass to a source of paths. The moments number its points consecutively. @param info complete
/// except for id and point count
GeneratedMoves movesOf(const PlannedPass& planned, GeneratedInfo info);

} // namespace burin
