// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pass_arguments.h"
#include "core/document/project_change.h"
#include "core/job/lead_lines.h"
#include "core/job/milling_context.h"

#include <optional>

namespace burin {

/// Computes a pass, appends it to the sources of a path or makes it the first of a new one, saves and answers. If the
/// arguments name a pass of the path, that one is replaced.
/// @param path without sources: a new one @param machine id; empty: that of the project @return exit status
int addPassTo(ProjectChange& project, StoredPath path, const PassArguments& arguments, const std::string& machine,
              CommandContext& context);

/// Which passes of a path are recomputed.
struct PassChoice {
    std::optional<std::int64_t> pass; ///< id; empty: all
    bool outdatedOnly = false;        ///< of all, those whose strokes have changed since they were computed
};
/// Recomputes passes of a path from their stored requests, with the strokes that lead them as they are now, keeping
/// their positions, saves and answers. @return exit status
int recompute(ProjectChange& project, StoredPath path, const PassChoice& choice, const std::string& machine,
              CommandContext& context);

/// Ids of the passes of a path whose strokes have changed since they were computed. @param milling with the path's tool
/// Errors: those of ledPasses and outdatedPasses.
Result<std::vector<std::int64_t>> outdatedPassesOf(const Project& project, const StoredPath& path,
                                                   const MillingContext& milling, KeptLeads& leads,
                                                   CommandContext& context);

/// Removes a path from a project, or one pass from a path, saves and answers; passes that no path uses any more are
/// removed as well. @param pass id; empty: the whole path @return exit status
int removeFrom(ProjectChange& project, StoredPath path, std::optional<std::int64_t> pass, CommandContext& context);

} // namespace burin
