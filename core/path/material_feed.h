// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"

namespace burin {

/// Gives the moves of a path, which has the feeds of one material, those of the materials that they meet, each stretch
/// the most careful: of what several ask for, and of what its neighbours do. Moves in air take what comes next. Plunges
/// come down by as much as the plunge feed does. Lines are divided at the borders, half a millimetre before the harder
/// one. A path has one spindle speed: the least that any material on it allows; chips stay as thick.
/// @param conditions by property, as the user wants them, within what tool and machine can do
/// @param feeds in the one material, of which the points have theirs
/// Errors: those of recordEngagement.
Result<void> feedByMaterial(PathUnderEdit& state, const PathContext& context,
                            const std::vector<CuttingConditions>& conditions, const CuttingConditions& feeds,
                            Progress& progress);

} // namespace burin
