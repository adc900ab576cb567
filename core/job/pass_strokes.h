// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/lead_lines.h"
#include "core/job/milling_context.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"
#include "core/path/stroke.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Returns the strokes of a take as guide lines for a pass. Errors: those of readLead and linesOf.
Result<LeadLines> linesOfTake(const Project& project, std::int64_t take, KeptLeads& kept, Progress& progress);

/// Puts the lines of takes, which were read, before the other lines of a request, and notes where they come from.
struct TakeLines {
    std::int64_t take = 0;
    LeadLines lines;
};
void leadBy(const std::vector<TakeLines>& takes, PassRequest& request);

/// Reads takes that lead a pass. Errors: those of readLead.
Result<std::vector<LeadTake>> readLeads(const Project& project, const std::vector<std::int64_t>& takes,
                                        const KeptLeads& kept, const Progress& progress);
/// The takes that lead a request.
std::vector<std::int64_t> takesOf(const PassRequest& request);
/// Returns the request with the lines of these takes before its own. Needs no project. Errors: those of linesOf.
Result<PassRequest> ledBy(PassRequest request, std::vector<LeadTake> leads, KeptLeads& kept, Progress& progress);
/// The same with the lines of these takes instead of those of the takes that led it.
Result<PassRequest> ledAnew(PassRequest request, std::vector<LeadTake> leads, KeptLeads& kept, Progress& progress);

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
        PassRequest request;               ///< as it was computed
        std::vector<LeadTake> leads;       ///< that lead it, as they are now
        bool leadGone = false;             ///< one of them is gone, or can't lead
        std::string digest;                ///< of the strokes that it was computed on; empty: it ignores them
        std::vector<SourceStrokes> before; ///< the takes before it in the path, unless it ignores them
    };
    std::vector<Pass> passes;
    StoredPath path;
};
/// Reads what is needed to tell. Errors: those of Project::generated and strokesOf; cancelled.
Result<LedPasses> ledPasses(const Project& project, const StoredPath& path, const KeptLeads& kept, Progress& progress);
/// Returns the ids of those passes whose strokes have changed since they were computed, in their order: computing them
/// again brings them up to date, and no other pass depends on what changed. Needs no project. Thread-safe, cancellable.
/// Errors: those of handStrokes. @param milling with the path's tool
Result<std::vector<std::int64_t>> outdatedPasses(LedPasses led, const MillingContext& milling, KeptLeads& kept,
                                                 Progress& progress);

} // namespace burin
