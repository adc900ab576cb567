// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"

#include <span>

namespace burin {

/// Takes out of a pass what would bring the tool nearer to an obstacle than its margin: strokes end before it and begin
/// again behind it, within 0.2 mm. What was taken out is added to `PlannedPass::inTheWay`. Any thread; cancellable.
/// @param obstacles those that are on count
void keepClear(PlannedPass& planned, std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles,
               const Progress& progress);

} // namespace burin
