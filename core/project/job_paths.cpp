// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/job_paths.h"

#include "core/path/tool_order.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr const char* toRecord = "burin mill";

Error withoutTake() {
    return {ErrorCode::projectIncomplete, "a recording", toRecord, {}};
}

/// Tools of takes, each once, in the order of their first takes.
std::vector<std::string> toolsOf(const std::vector<TakeInfo>& takes) {
    std::vector<std::string> tools;
    for (const TakeInfo& take : takes)
        if (std::ranges::find(tools, take.toolId) == tools.end()) tools.push_back(take.toolId);
    return tools;
}

/// What a path leaves on the part in the end, mm.
double allowanceOf(const PathMatter& matter) {
    return std::ranges::min_element(matter.takes, {}, [](const Take& take) { return take.info.allowance; })
        ->info.allowance;
}

/// In a sensible order, by orderPasses. @param allowances mm, that each path leaves on the part
ProgramPaths inOrder(ProgramPaths given, const std::vector<double>& allowances) {
    std::vector<ToolPass> passes;
    for (std::size_t i = 0; i < given.paths.size(); ++i) {
        const auto tool = std::ranges::find(given.tools, given.paths[i].toolId, &Tool::id);
        passes.push_back({given.paths[i].toolId, tool->cutter.diameter, allowances[i]});
    }
    ProgramPaths ordered{{}, std::move(given.tools)};
    for (const OrderedPass& pass : orderPasses(passes)) ordered.paths.push_back(std::move(given.paths[pass.pass]));
    return ordered;
}

} // namespace

std::string toolOf(const StoredPath& path, const std::vector<TakeInfo>& takes) {
    for (const std::int64_t id : path.takes)
        if (const auto take = std::ranges::find(takes, id, &TakeInfo::id); take != takes.end()) return take->toolId;
    return {};
}

bool isFirstOfItsTool(const StoredPath& path, const std::vector<StoredPath>& paths,
                      const std::vector<TakeInfo>& takes) {
    const std::string tool = toolOf(path, takes);
    const auto first =
        std::ranges::find_if(paths, [&](const StoredPath& other) { return toolOf(other, takes) == tool; });
    return first != paths.end() && first->id == path.id;
}

void addNewerTakes(StoredPath& path, const std::vector<TakeInfo>& takes) {
    const std::string tool = toolOf(path, takes);
    const auto newest = std::ranges::max_element(path.takes);
    if (newest == path.takes.end()) return;
    const std::int64_t last = *newest;
    for (const TakeInfo& take : takes)
        if (take.toolId == tool && take.id > last) path.takes.push_back(take.id);
}

Result<StoredPath> standardPath(const Project& project, const std::string& toolId) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    StoredPath path;
    for (const TakeInfo& take : *takes)
        if (take.toolId == toolId) path.takes.push_back(take.id);
    if (path.takes.empty()) return withoutTake();
    const Result<std::vector<StoredPath>> others = project.paths();
    if (!others) return others.error();
    path.name = "path " + std::to_string(others->size() + 1);
    path.edits = standardEdits();
    return path;
}

Result<std::vector<StoredPath>> jobPaths(Project& project) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    if (takes->empty()) return withoutTake();
    const Result<std::vector<StoredPath>> kept = project.paths();
    if (!kept) return kept.error();
    std::vector<StoredPath> paths;
    for (const std::string& tool : toolsOf(*takes)) {
        const auto first =
            std::ranges::find_if(*kept, [&](const StoredPath& path) { return toolOf(path, *takes) == tool; });
        if (first != kept->end()) {
            paths.push_back(*first);
            continue;
        }
        Result<StoredPath> made = standardPath(project, tool);
        if (!made) return std::move(made).error();
        const Result<std::int64_t> id = project.addPath(*made);
        if (!id) return id.error();
        made->id = *id;
        paths.push_back(std::move(*made));
    }
    return paths;
}

Result<PathMatter> matterOf(const Project& project, const StoredPath& path) {
    Result<std::vector<Take>> takes = takesOf(project, path);
    if (!takes) return std::move(takes).error();
    if (takes->empty()) return withoutTake();
    Result<Tool> tool = toolFor(project, takes->front().info.toolId);
    if (!tool) return std::move(tool).error();
    return PathMatter{path, std::move(*takes), std::move(*tool), nullptr};
}

Result<EvaluatedPaths> evaluateInOrder(const Bench& bench, const std::vector<PathMatter>& matters, Progress& progress) {
    EvaluatedPaths done;
    std::vector<double> allowances;
    for (const PathMatter& matter : matters) {
        Result<EvaluatedPath> path = matter.evaluated
                                         ? Result<EvaluatedPath>(*matter.evaluated)
                                         : evaluateStored(matter.takes, bench, matter.tool, matter.path, progress);
        if (!path) return std::move(path).error();
        done.program.paths.push_back(std::move(path->path));
        done.reports.insert(done.reports.end(), path->reports.begin(), path->reports.end());
        done.errorBudget = std::max(done.errorBudget, path->errorBudget);
        allowances.push_back(allowanceOf(matter));
        if (std::ranges::find(done.program.tools, matter.tool.id, &Tool::id) == done.program.tools.end())
            done.program.tools.push_back(matter.tool);
    }
    done.program = inOrder(std::move(done.program), allowances);
    return done;
}

} // namespace burin
