// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "core/job/milling_context.h"
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
    std::size_t unreachedHoles = 0;
};

/// What stands before a pass in the job. @param path that it becomes the last source of; without sources: a new one
/// @param instead the pass of the path whose place it takes: what comes behind that does not count
/// Errors: those of matterOf.
Result<std::vector<PathMatter>> pathsBeforePass(const Project& project, StoredPath path, const std::string& toolId,
                                                const PassRequest& request,
                                                std::optional<std::int64_t> instead = std::nullopt);

/// What passes are planned on besides part and tool. Any number of threads may read one.
struct PassBasis {
    StandingStock standing; ///< the stock as the paths before leave it
    std::shared_ptr<const ClearanceField> field;
    double allowance = 0.0; ///< mm, up to which the field is fine
};
/// Any thread. @param milling with the pass's tool @param allowance mm, the most that a pass may leave on the part
/// Errors: those of clearanceField and lendStockBehind.
Result<PassBasis> passBasis(const MillingContext& milling, std::vector<PathMatter> before, double allowance,
                            Progress& progress);

/// Plans a pass. Any thread. @param milling with the pass's tool @param coarseness see PassGround
/// Errors: those of planPass.
Result<PlannedPass> planOn(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                           double coarseness, Progress& progress);

/// Computes a pass on the stock as the paths before it leave it. Any thread.
/// @param milling with the pass's tool
/// Errors: those of passBasis and planOn; pathEmpty (nothing is left to do, or all of it had to
/// be left out).
Result<ComputedPass> computePass(const MillingContext& milling, std::vector<PathMatter> before,
                                 const PassRequest& request, Progress& progress);

/// A path with a pass as its last source, or as its first with the edits of computed paths.
/// @param path with or without sources @param source id of the pass in the project
/// @param instead the pass of the path whose place it takes
StoredPath withPass(StoredPath path, const std::string& passName, std::int64_t source,
                    std::optional<std::int64_t> instead = std::nullopt);

/// The path's sources, takes and passes, with one of them at another position. Each is milled behind those before it; a
/// pass keeps the moves that it was computed with until it is computed again.
/// Errors: nameUnknown (no source of the path), argumentInvalid (place: the position, detail: those that there are).
Result<std::vector<PathSource>> movedSource(std::vector<PathSource> sources, PathSource moved, std::size_t position);

/// The strokes of a take as lines that lead a pass: smoothed, so that a hand's tremor is in no row. mm, setup frame.
/// Errors: those of Project::take and evaluate; pathEmpty.
Result<std::vector<PassLine>> linesOfTake(const Project& project, std::int64_t take, Progress& progress);

} // namespace burin
