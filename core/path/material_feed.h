// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"
#include "core/path/machine_edits.h"

namespace burin {

/// Gives the moves of a path, which has the feeds of one material, those of the materials that they meet, each stretch
/// the most careful: of what several ask for, and of what its neighbours do. Moves in air take what comes next. Plunges
/// come down by as much as the plunge feed does. Lines are divided at the borders, half a millimetre before the harder
/// one. Chips stay as thick at whatever speed the spindle has.
/// @param spindle one speed: the least that any material on the path allows; by material: as spindleSchedule has it
/// @param conditions by property, as the user wants them, within what tool and machine can do
/// @param feeds in the one material, of which the points have theirs
/// Errors: those of recordEngagement.
Result<void> feedByMaterial(PathUnderEdit& state, const PathContext& context,
                            const std::vector<CuttingConditions>& conditions, const CuttingConditions& feeds,
                            SetFeed::Spindle spindle, Progress& progress);

} // namespace burin
