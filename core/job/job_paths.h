// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/path/tool_order.h"

#include <memory>

namespace burin {

/// Returns the id of the tool that a path's sources were made with. Empty if none of them is among `sources`.
std::string toolOf(const StoredPath& path, const std::vector<SourceInfo>& sources);

/// Whether a path is the one that the job mills with its tool: the first path of that tool. The others are variants.
bool isFirstOfItsTool(const StoredPath& path, const std::vector<StoredPath>& paths,
                      const std::vector<SourceInfo>& sources);

/// Returns the takes that a job is made of: all except those whose strokes are all undone at present. Reads the samples
/// of takes with undone strokes. Errors: those of Project::takes and Project::visitSamples.
Result<std::vector<TakeInfo>> standingTakes(const Project& project);

/// Returns the take that was recorded last, whatever its position in the list, which must not be empty.
const TakeInfo& newestTake(const std::vector<TakeInfo>& takes);

/// Returns all possible sources of paths: every take, in the order of recording, then all generated passes. This is the
/// order of the job, which stays unchanged when takes are moved. Errors: those of Project::takes and
/// Project::generated.
Result<std::vector<SourceInfo>> sourcesOf(const Project& project);
std::vector<SourceInfo> sourcesOf(const std::vector<TakeInfo>& takes, const std::vector<GeneratedInfo>& generated);

/// Adds to a path the takes of its tool that are newer than all of its own. Older takes that it lacks were left out on
/// purpose, as were generated passes; a path of generated moves alone stays unchanged. Copies of takes are not added,
/// as they would mill the same twice.
void addNewerTakes(StoredPath& path, const std::vector<SourceInfo>& sources);

/// Returns a path of all standing takes of one tool, in their order, with the edits of the main job; it has no id yet.
/// A copy is included only if its original is not a standing take.
/// Errors: projectIncomplete (no such take), those of standingTakes.
Result<StoredPath> standardPath(const Project& project, const std::string& toolId);

/// Returns the paths that the job mills: the first path of each tool of standing sources, in the order of these. For a
/// tool with takes but no path, a new path is made and stored in the project. Errors: projectIncomplete (nothing to
/// mill), those of Project::addPath.
Result<std::vector<StoredPath>> jobPaths(Project& project);

/// Returns the job's paths among all paths of a project: the first of each tool.
std::vector<StoredPath> firstPaths(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources);

/// Returns the paths of a job in the order in which they are milled, evaluated (evaluateInOrder) and written to the
/// program: by orderPasses; ties are ordered by when their tools first milled.
/// @param milled  tools of standing sources in the order of their first sources. @param tools  the known tools; an
/// unknown tool counts as one without a diameter
std::vector<StoredPath> inMillingOrder(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources,
                                       const std::vector<std::string>& milled, const std::vector<Tool>& tools);

/// Returns the tools of sources, each once, in the order of their first sources.
std::vector<std::string> toolsOf(const std::vector<SourceInfo>& sources);

/// Returns the sources that a job is made of: its standing takes, then the generated passes. Errors: those of
/// standingTakes.
Result<std::vector<SourceInfo>> standingSources(const Project& project);

/// Returns what the position of a path in the milling order depends on. @param sources include those of the path
ToolPass passOf(const StoredPath& path, const Tool& tool, const std::vector<SourceInfo>& sources);

/// A stored path with everything that its evaluation needs.
struct PathMatter {
    StoredPath path;
    std::vector<SourceStrokes> sources;
    Tool tool;
    /// The result of an earlier evaluation of exactly this path; valid as long as the preceding paths are those that it
    /// was evaluated behind. Null: not evaluated yet.
    std::shared_ptr<const EvaluatedPath> evaluated;
};
/// Errors: projectIncomplete (a path without sources), those of strokesOf and toolFor.
Result<PathMatter> matterOf(const Project& project, const StoredPath& path);
/// The same without reading what its sources recorded: enough for a path that is evaluated already (areEvaluated).
Result<PathMatter> outlinedMatterOf(const Project& project, const StoredPath& path);
/// Whether evaluateInOrder takes all these paths as they are evaluated, and needs no strokes.
bool areEvaluated(const std::vector<PathMatter>& matters);

/// The paths of one job in milling order, and the reports of their edits.
struct EvaluatedPaths {
    ProgramPaths program;
    std::vector<EditReport> reports;
    double errorBudget = 0.0; ///< mm, largest of all paths
};
/// Orders paths by orderPasses and evaluates each on the stock left by the preceding ones.
/// Errors: those of evaluateStored.
/// @param matters moved from where possible
Result<EvaluatedPaths> evaluateInOrder(const MillingContext& milling, std::vector<PathMatter> matters,
                                       Progress& progress);

/// Returns the job's paths that are milled before a further source of a path, in milling order, including the path's
/// existing sources.
/// @param path of `next`'s tool, with or without sources @param next its tool and allowance
/// Errors: those of matterOf.
Result<std::vector<PathMatter>> pathsBefore(const Project& project, const StoredPath& path, const SourceInfo& next);

/// Lends the stock left by paths that are milled in this order. Errors: those of evaluateStored, MilledStock::lend and
/// `use`.
Result<void> lendStockBehind(const MillingContext& milling, std::vector<PathMatter> paths, const StockUse& use,
                             Progress& progress);

/// Returns all paths of a project as the job mills them: those of the job, then their variants. Paths that are empty
/// after their edits are left out.
/// Errors: those of matterOf, evaluateInOrder and evaluateInJob.
Result<std::vector<Path>> promisedPaths(const Project& project, const MillingContext& milling, Progress& progress);

/// Evaluates a path as the job mills it, behind the job's paths that precede it; a variant takes the place of the job's
/// own path. Errors: those of matterOf and evaluateStored.
Result<EvaluatedPath> evaluateInJob(const Project& project, const MillingContext& milling, const StoredPath& path,
                                    Progress& progress);

} // namespace burin
