// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/path/tool_order.h"

#include <memory>

namespace burin {

/// The tool that a path's sources were made with, by id. Empty: none of them is among `sources`.
std::string toolOf(const StoredPath& path, const std::vector<SourceInfo>& sources);

/// Whether a path is the one that the job mills with its tool: the first of that tool. Others are variants of it.
bool isFirstOfItsTool(const StoredPath& path, const std::vector<StoredPath>& paths,
                      const std::vector<SourceInfo>& sources);

/// Takes that a job is made of: not those whose strokes were all taken back, as long as nobody redoes one. Reads the
/// samples of takes of which something was taken back. Errors: those of Project::takes and Project::visitSamples.
Result<std::vector<TakeInfo>> standingTakes(const Project& project);

/// What paths can be made of: every take, then all that planners made. Errors: those of Project::takes and
/// Project::generated.
Result<std::vector<SourceInfo>> sourcesOf(const Project& project);
std::vector<SourceInfo> sourcesOf(const std::vector<TakeInfo>& takes, const std::vector<GeneratedInfo>& generated);

/// Adds the takes of its tool that are newer than all of its own. Older ones that it lacks were left out on purpose,
/// and so was what a planner made; a path of generated moves alone stays as it is.
void addNewerTakes(StoredPath& path, const std::vector<SourceInfo>& sources);

/// A path of all standing takes of one tool with the edits of the main job; no id yet.
/// Errors: projectIncomplete (no such take), those of standingTakes.
Result<StoredPath> standardPath(const Project& project, const std::string& toolId);

/// What the job mills with: the first path of each tool of standing sources, in the order of these. A tool of takes
/// that no path is of yet gets a new one, which the project keeps. Errors: projectIncomplete (nothing to mill), those
/// of Project::addPath.
Result<std::vector<StoredPath>> jobPaths(Project& project);

/// The job's paths among all of a project: the first of each tool.
std::vector<StoredPath> firstPaths(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources);

/// Paths of a job in the order in which it mills them, evaluates them (evaluateInOrder) and has them in its program: by
/// orderPasses, and what that does not tell apart in the order in which their tools first milled.
/// @param milled  tools of standing sources in the order of their first ones. @param tools  known ones; another counts
/// as one without a diameter
std::vector<StoredPath> inMillingOrder(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources,
                                       const std::vector<std::string>& milled, const std::vector<Tool>& tools);

/// Tools of sources, each once, in the order of their first ones.
std::vector<std::string> toolsOf(const std::vector<SourceInfo>& sources);

/// What a job is made of: its standing takes, then what planners made. Errors: those of standingTakes.
Result<std::vector<SourceInfo>> standingSources(const Project& project);

/// What the place of a path among others depends on. @param takes its own among them
ToolPass passOf(const StoredPath& path, const Tool& tool, const std::vector<SourceInfo>& sources);

/// A stored path with what it takes to evaluate it.
struct PathMatter {
    StoredPath path;
    std::vector<SourceStrokes> sources;
    Tool tool;
    /// Just this path, where it was evaluated before; counts where the paths before it are still those that it was
    /// evaluated to come after. Null: still to be done.
    std::shared_ptr<const EvaluatedPath> evaluated;
};
/// Errors: projectIncomplete (a path without sources), those of strokesOf and toolFor.
Result<PathMatter> matterOf(const Project& project, const StoredPath& path);

/// Paths of one job in the order in which they are milled, and what their edits did.
struct EvaluatedPaths {
    ProgramPaths program;
    std::vector<EditReport> reports;
    double errorBudget = 0.0; ///< mm, of the worst path
};
/// Puts paths in order by orderPasses and evaluates each on the stock as those before it leave it.
/// Errors: those of evaluateStored.
/// @param matters moved from, where they may be
Result<EvaluatedPaths> evaluateInOrder(const MillingContext& milling, std::vector<PathMatter> matters,
                                       Progress& progress);

/// The job's paths that are milled before a further source of a path, in their order, what the path has already among
/// them.
/// @param path of `next`'s tool, with or without sources @param next its tool and allowance
/// Errors: those of matterOf.
Result<std::vector<PathMatter>> pathsBefore(const Project& project, const StoredPath& path, const SourceInfo& next);

/// Lends the stock as paths, in this order, leave it. Errors: those of evaluateStored, MilledStock::lend and `use`.
Result<void> lendStockBehind(const MillingContext& milling, std::vector<PathMatter> paths, const StockUse& use,
                             Progress& progress);

/// All paths of a project as the job mills them: those of the job, then their variants; what edits leave nothing of
/// promises nothing.
/// Errors: those of matterOf, evaluateInOrder and evaluateInJob.
Result<std::vector<Path>> promisedPaths(const Project& project, const MillingContext& milling, Progress& progress);

/// A path as the job mills it, behind those of the job's paths that come before it; in the stead of the job's own where
/// it is a variant. Errors: those of matterOf and evaluateStored.
Result<EvaluatedPath> evaluateInJob(const Project& project, const MillingContext& milling, const StoredPath& path,
                                    Progress& progress);

} // namespace burin
