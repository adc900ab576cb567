// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/path/evaluate.h"

#include <cstdint>
#include <vector>

namespace burin {

class Project;

/// What the moves that come from a computed pass do to the stock, by the volume that the path is cut out of again.
/// Moves that edits add on their own, as links do, belong to no pass.
struct PassFigures {
    std::int64_t pass = 0; ///< id
    double length = 0.0;   ///< mm, of moves at a feed
    double duration = 0.0; ///< s, of these, at their feeds
    double airShare = 0.0; ///< of the length: nothing is cut there
    double removed = 0.0;  ///< mm³
    /// rad, of the cutter's circumference that meets stock: what it stays within for 95 % of the length that cuts, and
    /// at most. As right as Engagement::arc.
    double engagement95 = 0.0, engagementMost = 0.0;
};

/// Of each pass of a path, in its order; none where it has none.
/// @param evaluated the path as it is milled in the job. Cost: cuts the path once. Cancellable.
/// Errors: those of toolFor, MilledStock::lend and recordEngagement.
Result<std::vector<PassFigures>> passFigures(const Project& project, const MillingContext& milling,
                                             const StoredPath& path, const EvaluatedPath& evaluated,
                                             Progress& progress);

} // namespace burin
