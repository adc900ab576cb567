// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Levels, pocket, profile, face. From the top of what stands to the bottom, in equal steps between the part's level
/// faces. On each level the tool goes in loops at even distances from the part (and from the border of an area),
/// from the outermost to the part, with the part to its right: it climbs all the way. Loops go only where stock is
/// left; what lies within a step of each other is gone without lifting. Errors: argumentInvalid (a step-over wider than
/// the cutter's radius; a bottom above the stock), cancelled.
Result<PlannedPass> planLevels(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
