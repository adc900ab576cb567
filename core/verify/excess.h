// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <span>

namespace burin {

/// mm: longer ways through stock are not followed, as it was simply never touched there. Such an excess means "at
/// least".
inline constexpr double longestExcess = 20.0;

/// How much stock a workpiece leaves over the part, at places spread over the part's surface about a voxel apart: the
/// length along the outward normal until the stock ends, at most `longestExcess`. Reachable are places that face
/// upwards or sideways and are bare, or that the cutter can touch from above (tip not below the part's lowest point)
/// without entering the part elsewhere.
/// @param tools that the program uses: reachable is what one of them can touch
/// Errors: cancelled.
Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, Progress& progress);

} // namespace burin
