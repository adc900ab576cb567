// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/path/stroke.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Returns the strokes of a take as guide lines for a pass, smoothed so that no row contains the tremor of the hand.
/// mm, setup frame.
/// Errors: those of Project::take and evaluate; pathEmpty.
Result<std::vector<PassLine>> linesOfTake(const Project& project, std::int64_t take, Progress& progress);

/// Puts the lines of takes, which were read, before the other lines of a request, and notes where they come from.
struct TakeLines {
    std::int64_t take = 0;
    std::vector<PassLine> lines;
};
void leadBy(const std::vector<TakeLines>& takes, PassRequest& request);

/// Returns the request with the lines of its leads as the takes have them now. Errors: those of linesOfTake.
Result<PassRequest> ledAnew(const Project& project, PassRequest request, Progress& progress);

/// Returns the strokes of the hand among the sources of a path, as the edits of the path shape them before they are
/// linked: tips, mm, setup frame. Thread-safe.
/// @param sources of the path or some of them; generated ones are left out @param milling with the path's tool
/// Errors: those of evaluate; nothing left of them is no error.
Result<std::vector<TipLine>> handStrokes(std::vector<SourceStrokes> sources, const StoredPath& path,
                                         const MillingContext& milling, Progress& progress);
/// Identifies strokes: 16 hexadecimal digits that change with any tip by 1e-6 mm.
std::string digestOf(const std::vector<TipLine>& strokes);

/// The passes of a path that depend on strokes of the hand, and these strokes.
struct LedPasses {
    struct Pass {
        std::int64_t id = 0;
        bool linesChanged = false;         ///< the takes that lead it have other strokes by now, or are gone
        std::string digest;                ///< of the strokes that it was computed on; empty: it ignores them
        std::vector<SourceStrokes> before; ///< the takes before it in the path, unless it ignores them
    };
    std::vector<Pass> passes;
    StoredPath path;
};
/// Errors: those of Project::generated and strokesOf; cancelled.
Result<LedPasses> ledPasses(const Project& project, const StoredPath& path, Progress& progress);
/// Returns the ids of those passes whose strokes have changed since they were computed, in their order: computing them
/// again brings them up to date, and no other pass depends on what changed. Thread-safe. Errors: those of handStrokes.
/// @param milling with the path's tool
Result<std::vector<std::int64_t>> outdatedPasses(LedPasses led, const MillingContext& milling, Progress& progress);

} // namespace burin
