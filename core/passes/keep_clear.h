// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"

#include <span>

namespace burin {

/// Removes from a pass what would bring the tool closer to an obstacle than the margin of that obstacle: strokes end
/// before the obstacle and begin again behind it, to within 0.2 mm. The length removed is added to
/// `PlannedPass::inTheWay`. Thread-safe; cancellable.
/// @param obstacles only those that are switched on count
void keepClear(PlannedPass& planned, std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles,
               const Progress& progress);

} // namespace burin
