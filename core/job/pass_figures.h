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

/// The effect of a computed pass's moves on the stock, measured by cutting the path out of the volume again. Moves that
/// are added by edits, such as links, belong to no pass.
struct PassFigures {
    std::int64_t pass = 0; ///< id
    double length = 0.0;   ///< mm, of moves at a feed
    double duration = 0.0; ///< s, of these, at their feeds
    double airShare = 0.0; ///< share of the length on which nothing is cut
    double removed = 0.0;  ///< mm³
    /// Engagement angle of the cutter, rad: not exceeded on 95 % of the cutting length, and the maximum. As accurate as
    /// Engagement::arc.
    double engagement95 = 0.0, engagementMost = 0.0;
    std::optional<StockLeft> left{}; ///< after it and all preceding passes; empty for holes and engraved lines
};

/// The data of the project that measuring passes needs.
struct FigureMatter {
    std::vector<MilledPath> before;               ///< paths milled before the path, in order
    std::map<std::int64_t, PassRequest> requests; ///< requests of the passes, by id
};
/// @param evaluated the path as milled in the job. Errors: those of toolFor and Project::generated.
Result<FigureMatter> figureMatter(const Project& project, const EvaluatedPath& evaluated);

/// Returns the values of each pass of a path, in order; empty if it has no passes. Thread-safe.
/// @param evaluated the path as milled in the job. Cost: cuts the path once, and sweeps all preceding paths past the
/// part. Cancellable. Errors: those of MilledStock::lend and recordEngagement.
Result<std::vector<PassFigures>> passFigures(const FigureMatter& matter, const MillingContext& milling,
                                             const StoredPath& path, const EvaluatedPath& evaluated,
                                             Progress& progress);

} // namespace burin
