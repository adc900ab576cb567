// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milled_stock.h"
#include "core/job/milling_context.h"
#include "core/job/stock_left.h"
#include "core/passes/pass_request.h"
#include "core/path/evaluate.h"

#include <cstdint>
#include <map>
#include <optional>
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
    std::optional<StockLeft> left{}; ///< behind it and all before it; nothing for holes and engraved lines
};

/// What measuring passes takes from the project.
struct FigureMatter {
    std::vector<MilledPath> before;               ///< what is milled before the path, in order
    std::map<std::int64_t, PassRequest> requests; ///< what passes were asked for, by id
};
/// @param evaluated the path as it is milled in the job. Errors: those of toolFor and Project::generated.
Result<FigureMatter> figureMatter(const Project& project, const EvaluatedPath& evaluated);

/// Of each pass of a path, in its order; none where it has none. Any thread.
/// @param evaluated the path as it is milled in the job. Cost: cuts the path once, and sweeps all paths before it past
/// the part. Cancellable. Errors: those of MilledStock::lend and recordEngagement.
Result<std::vector<PassFigures>> passFigures(const FigureMatter& matter, const MillingContext& milling,
                                             const StoredPath& path, const EvaluatedPath& evaluated,
                                             Progress& progress);

} // namespace burin
