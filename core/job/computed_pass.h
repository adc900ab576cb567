// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "core/job/milling_context.h"
#include "core/job/pass_strokes.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/recording/generated_moves.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace burin {

/// A pass that was computed for a path.
struct ComputedPass {
    GeneratedMoves moves;                 ///< with its request; no id yet
    double length = 0.0;                  ///< mm, of its strokes
    double leftOut = 0.0, inTheWay = 0.0; ///< mm, see PlannedPass
    double leftToHand = 0.0;              ///< mm, see PlannedPass
    std::size_t unreachedHoles = 0;
};

/// Returns the paths that are milled before a pass in the job. @param path whose last source the pass becomes; a path
/// without sources is a new one
/// @param instead the pass of the path that it replaces; sources behind that pass are ignored
/// Errors: those of matterOf.
Result<std::vector<PathMatter>> pathsBeforePass(const Project& project, StoredPath path, const std::string& toolId,
                                                const PassRequest& request,
                                                std::optional<std::int64_t> instead = std::nullopt);

/// The input for planning passes, in addition to part and tool. Any number of threads may read one.
struct PassBasis {
    StandingStock standing;                          ///< the stock left by the preceding paths
    std::shared_ptr<const ClearanceField> field;     ///< see PassGround; null where the tool needs none
    double allowance = 0.0;                          ///< mm, up to which the field has full resolution
    std::optional<std::vector<TipLine>> handStrokes; ///< before the pass in its own path; empty: not asked for
};
/// Thread-safe. @param milling with the pass's tool @param before as pathsBeforePass returns them @param allowance mm,
/// the largest that a pass may leave on the part @param heedsHand whether the strokes of the hand are needed
/// Errors: those of clearanceField, lendStockBehind and handStrokes.
Result<PassBasis> passBasis(const MillingContext& milling, std::vector<PathMatter> before, double allowance,
                            bool heedsHand, Progress& progress);

/// Plans a pass. Thread-safe. @param milling with the pass's tool @param coarseness see PassGround
/// Errors: those of planPass.
Result<PlannedPass> planOn(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                           double coarseness, Progress& progress);

/// The feed of the tool's centre to a point of a stroke, mm/min: a share of the cutting feed; down through air, where
/// the share is 0, the plunge feed.
double plannedFeed(const PlannedPass& planned, std::size_t stroke, std::size_t point,
                   const CuttingConditions& conditions);

/// Computes a pass on the stock left by the preceding paths. Thread-safe.
/// @param milling with the pass's tool
/// Errors: those of passBasis and planOn; pathEmpty (nothing is left to do, or all of it had to be left out).
Result<ComputedPass> computePass(const MillingContext& milling, std::vector<PathMatter> before,
                                 const PassRequest& request, Progress& progress);

/// What a stored pass does in round holes, if it works in any.
HoleWork holeWorkOf(const GeneratedInfo& pass);
/// Whether a stored pass mills threads: it states the feeds of its moves, and the circle that it follows lies outside
/// of the facets of its holes, or touches the corners of its studs.
bool millsThreads(const GeneratedInfo& pass);

/// Returns the path with a pass added as its last source; a path without sources also gets the edits of computed paths.
/// For a pass that states the feeds of its moves (threads), the path's edits use these.
/// @param path with or without sources @param pass its name and request @param source id of the pass in the project
/// @param instead the pass of the path that it replaces
StoredPath withPass(StoredPath path, const GeneratedInfo& pass, std::int64_t source,
                    std::optional<std::int64_t> instead = std::nullopt);

/// Returns the path's sources, takes and passes, with one of them moved to another position. Sources are milled in this
/// order; a pass keeps its computed moves until it is computed again.
/// Errors: nameUnknown (not a source of the path), argumentInvalid (place: the position, detail: the valid positions).
Result<std::vector<PathSource>> movedSource(std::vector<PathSource> sources, PathSource moved, std::size_t position);

} // namespace burin
