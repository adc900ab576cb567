// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/path/tool_order.h"

#include <memory>

namespace burin {

/// The tool that a path's takes were made with, by id. Empty: none of them is among `takes`.
std::string toolOf(const StoredPath& path, const std::vector<TakeInfo>& takes);

/// Whether a path is the one that the job mills with its tool: the first of that tool. Others are variants of it.
bool isFirstOfItsTool(const StoredPath& path, const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes);

/// Takes that a job is made of: not those whose strokes were all taken back, as long as nobody redoes one. Reads the
/// samples of takes of which something was taken back. Errors: those of Project::takes and Project::visitSamples.
Result<std::vector<TakeInfo>> standingTakes(const Project& project);

/// Adds the recordings of its tool that are newer than all of its own. Older ones that it lacks were left out on
/// purpose.
void addNewerTakes(StoredPath& path, const std::vector<TakeInfo>& takes);

/// A path of all standing takes of one tool with the edits of the main job; no id yet.
/// Errors: projectIncomplete (no such take), those of standingTakes.
Result<StoredPath> standardPath(const Project& project, const std::string& toolId);

/// What the job mills with: the first path of each tool of standing takes, in the order of these. A tool that no path
/// is of yet gets a new one, which the project keeps. Errors: projectIncomplete (no take), those of Project::addPath.
Result<std::vector<StoredPath>> jobPaths(Project& project);

/// The job's paths among all of a project: the first of each tool.
std::vector<StoredPath> firstPaths(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes);

/// Paths of a job in the order in which it mills them, evaluates them (evaluateInOrder) and has them in its program: by
/// orderPasses, and what that does not tell apart in the order in which their tools first milled.
/// @param milled  tools of standing takes in the order of their first ones. @param tools  known ones; another counts as
/// one without a diameter
std::vector<StoredPath> inMillingOrder(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes,
                                       const std::vector<std::string>& milled, const std::vector<Tool>& tools);

/// Tools of takes, each once, in the order of their first takes.
std::vector<std::string> toolsOf(const std::vector<TakeInfo>& takes);

/// What the place of a path among others depends on. @param takes its own among them
ToolPass passOf(const StoredPath& path, const Tool& tool, const std::vector<TakeInfo>& takes);

/// A stored path with what it takes to evaluate it.
struct PathMatter {
    StoredPath path;
    std::vector<RecordedStrokes> recorded;
    Tool tool;
    /// Just this path, where it was evaluated before; counts where the paths before it are still those that it was
    /// evaluated to come after. Null: still to be done.
    std::shared_ptr<const EvaluatedPath> evaluated;
};
/// Errors: projectIncomplete (a path without takes), those of recordedOf and toolFor.
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
Result<EvaluatedPaths> evaluateInOrder(const Bench& bench, std::vector<PathMatter> matters, Progress& progress);

/// All paths of a project as the job mills them: those of the job, then their variants; what edits leave nothing of
/// promises nothing.
/// Errors: those of matterOf, evaluateInOrder and evaluateInJob.
Result<std::vector<Path>> promisedPaths(const Project& project, const Bench& bench, Progress& progress);

/// A path as the job mills it, behind those of the job's paths that come before it; in the stead of the job's own where
/// it is a variant. Errors: those of matterOf and evaluateStored.
Result<EvaluatedPath> evaluateInJob(const Project& project, const Bench& bench, const StoredPath& path,
                                    Progress& progress);

} // namespace burin
