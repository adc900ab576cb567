// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Plans levels, pocket, profile and face. The levels go from the top of the standing stock to the bottom, in equal
/// steps between the level faces of the part. On each level the tool follows loops at even distances from the part (and
/// from the border of an area), from the outermost loop to the part. The part is to the right of the tool, so that all
/// loops are climb milled. Loops are kept only where stock is left; gaps of up to one
/// diameter of the cutter in a loop, and links of up to three step-overs, are traversed at feed without a retract.
/// Errors: argumentInvalid (a step-over larger than the radius of the cutter; a bottom above the stock), cancelled.
Result<PlannedPass> planLevels(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
