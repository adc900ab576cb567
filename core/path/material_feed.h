// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"
#include "core/path/machine_edits.h"

namespace burin {

/// Adjusts the moves of a path, which has the feeds of one material, to the materials that they meet. Each interval
/// gets the lowest feed: of those of its materials, and of its neighbours. Moves in air take the feed of the next
/// material. Plunges are reduced by the same ratio as the plunge feed. Lines are divided at the borders, half a
/// millimetre before the harder material. The chip load is kept at any spindle speed.
/// @param spindle one speed: the lowest that any material on the path allows; by material: see spindleSchedule
/// @param conditions by property, as the user requested them, within the limits of tool and machine
/// @param feeds in the one material, from which the points have theirs
/// Errors: those of recordEngagement.
Result<void> feedByMaterial(PathUnderEdit& state, const PathContext& context,
                            const std::vector<CuttingConditions>& conditions, const CuttingConditions& feeds,
                            SetFeed::Spindle spindle, Progress& progress);

} // namespace burin
