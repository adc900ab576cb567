// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/job_paths.h"

#include "core/recording/stroke_count.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace burin {

namespace {

constexpr const char* toRecord = "burin mill";

Error withoutTake() {
    return {ErrorCode::projectIncomplete, "a recording", toRecord, {}};
}

Result<std::size_t> standingStrokes(const Project& project, std::int64_t id) {
    const Result<TakeOutline> take = project.takeOutline(id);
    if (!take) return take.error();
    StrokeCounter counter(take->undone);
    Result<void> read = project.visitSamples(id, [&counter](std::span<const Sample> samples) -> Result<void> {
        counter.add(samples);
        return {};
    });
    if (!read) return std::move(read).error();
    return counter.strokes();
}

std::vector<std::size_t> placesOf(const std::vector<ToolPass>& passes) {
    std::vector<std::size_t> order;
    for (const OrderedPass& pass : orderPasses(passes)) order.push_back(pass.pass);
    return order;
}

/// Returns the paths in the order in which their tools first milled: orderPasses keeps this order for ties.
std::vector<StoredPath> byFirstTake(std::vector<StoredPath> paths, const std::vector<SourceInfo>& sources,
                                    const std::vector<std::string>& milled) {
    std::ranges::stable_sort(paths, {}, [&](const StoredPath& path) {
        return std::ranges::find(milled, toolOf(path, sources)) - milled.begin();
    });
    return paths;
}

/// Returns the indices of paths in milling order.
std::vector<std::size_t> milledOrder(const std::vector<PathMatter>& matters) {
    std::vector<ToolPass> passes;
    for (const PathMatter& matter : matters) {
        std::vector<SourceInfo> sources;
        for (const SourceStrokes& each : matter.sources) sources.push_back(each.info);
        passes.push_back(passOf(matter.path, matter.tool, sources));
    }
    return placesOf(passes);
}

bool comesAfter(const EvaluatedPath& path, const std::vector<MilledPath>& before) {
    return std::ranges::equal(path.after, before, {}, {}, &MilledPath::evaluated);
}

/// Evaluates paths in a given order, each on the stock left by the preceding ones.
Result<std::vector<MilledPath>> evaluateEach(const MillingContext& milling, std::vector<PathMatter> matters,
                                             const std::vector<std::size_t>& order, Progress& progress) {
    std::vector<MilledPath> milled;
    for (const std::size_t place : order) {
        PathMatter& matter = matters[place];
        const auto count = static_cast<double>(order.size()), done = static_cast<double>(milled.size());
        const ProgressPart part(progress, done / count, (done + 1.0) / count);
        if (matter.evaluated && comesAfter(*matter.evaluated, milled)) {
            milled.push_back({matter.evaluated, matter.tool});
            continue;
        }
        Result<EvaluatedPath> path =
            evaluateStored(std::move(matter.sources), milling, matter.tool, matter.path, milled, progress);
        if (!path) return std::move(path).error();
        milled.push_back({std::make_shared<const EvaluatedPath>(std::move(*path)), matter.tool});
    }
    return milled;
}

/// Returns the takes, followed by the generated passes.
Result<std::vector<SourceInfo>> withGenerated(const Project& project, const Result<std::vector<TakeInfo>>& takes) {
    if (!takes) return takes.error();
    const Result<std::vector<GeneratedInfo>> generated = project.generated();
    if (!generated) return generated.error();
    return sourcesOf(*takes, *generated);
}

} // namespace

std::vector<std::string> toolsOf(const std::vector<SourceInfo>& sources) {
    std::vector<std::string> tools;
    for (const SourceInfo& each : sources)
        if (std::ranges::find(tools, each.toolId) == tools.end()) tools.push_back(each.toolId);
    return tools;
}

std::string toolOf(const StoredPath& path, const std::vector<SourceInfo>& sources) {
    for (const PathSource source : path.sources)
        if (const auto known = std::ranges::find(sources, source, &SourceInfo::source); known != sources.end())
            return known->toolId;
    return {};
}

bool isFirstOfItsTool(const StoredPath& path, const std::vector<StoredPath>& paths,
                      const std::vector<SourceInfo>& sources) {
    const std::string tool = toolOf(path, sources);
    const auto first =
        std::ranges::find_if(paths, [&](const StoredPath& other) { return toolOf(other, sources) == tool; });
    return first != paths.end() && first->id == path.id;
}

std::vector<StoredPath> firstPaths(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources) {
    std::vector<StoredPath> firsts;
    for (const StoredPath& path : paths)
        if (!toolOf(path, sources).empty() && isFirstOfItsTool(path, paths, sources)) firsts.push_back(path);
    return firsts;
}

std::vector<StoredPath> inMillingOrder(const std::vector<StoredPath>& paths, const std::vector<SourceInfo>& sources,
                                       const std::vector<std::string>& milled, const std::vector<Tool>& tools) {
    const std::vector<StoredPath> given = byFirstTake(paths, sources, milled);
    std::vector<ToolPass> passes;
    for (StoredPath path : given) {
        addNewerTakes(path, sources); // they are milled as well
        const std::string id = toolOf(path, sources);
        const auto known = std::ranges::find(tools, id, &Tool::id);
        Tool unknown;
        unknown.id = id;
        passes.push_back(passOf(path, known != tools.end() ? *known : unknown, sources));
    }
    std::vector<StoredPath> ordered;
    for (const std::size_t place : placesOf(passes)) ordered.push_back(given[place]);
    return ordered;
}

ToolPass passOf(const StoredPath& path, const Tool& tool, const std::vector<SourceInfo>& sources) {
    double allowance = std::numeric_limits<double>::infinity(); // left by the complete path
    for (const SourceInfo& each : sources)
        if (std::ranges::find(path.sources, each.source) != path.sources.end())
            allowance = std::min(allowance, each.allowance);
    return {tool.id, tool.cutter.diameter, std::isfinite(allowance) ? allowance : 0.0};
}

std::vector<SourceInfo> sourcesOf(const std::vector<TakeInfo>& takes, const std::vector<GeneratedInfo>& generated) {
    std::vector<SourceInfo> sources;
    for (const TakeInfo& take : takes) sources.push_back(sourceOf(take));
    std::ranges::sort(sources, {}, [](const SourceInfo& each) { return each.source.id; }); // in the order of recording
    for (const GeneratedInfo& made : generated) sources.push_back(sourceOf(made));
    return sources;
}

const TakeInfo& newestTake(const std::vector<TakeInfo>& takes) {
    return *std::ranges::max_element(takes, {}, &TakeInfo::id);
}

Result<std::vector<SourceInfo>> sourcesOf(const Project& project) {
    return withGenerated(project, project.takes());
}

Result<std::vector<TakeInfo>> standingTakes(const Project& project) {
    Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes;
    std::vector<TakeInfo> standing;
    for (TakeInfo& info : *takes) {
        if (info.undoneCount > 0) {
            const Result<std::size_t> strokes = standingStrokes(project, info.id);
            if (!strokes) return strokes.error();
            if (*strokes == 0) continue;
        }
        standing.push_back(std::move(info));
    }
    return standing;
}

Result<std::vector<SourceInfo>> standingSources(const Project& project) {
    return withGenerated(project, standingTakes(project));
}

void addNewerTakes(StoredPath& path, const std::vector<SourceInfo>& sources) {
    const std::string tool = toolOf(path, sources);
    const auto newest = std::ranges::max_element(path.sources, {}, &PathSource::id);
    if (newest == path.sources.end() || !newest->isTake()) return;
    const std::int64_t last = newest->id;
    for (const SourceInfo& each : sources)
        if (each.toolId == tool && each.source.id > last && !each.copy) path.sources.push_back(each.source);
}

Result<StoredPath> standardPath(const Project& project, const std::string& toolId) {
    const Result<std::vector<TakeInfo>> takes = standingTakes(project);
    if (!takes) return takes.error();
    StoredPath path;
    // Of a take and its copies one is milled: the recording itself, or, if that does not stand, the first copy.
    std::set<std::int64_t> milled;
    for (const TakeInfo& take : *takes)
        if (take.copyOf == 0) milled.insert(take.id);
    for (const TakeInfo& take : *takes)
        if (take.toolId == toolId && (take.copyOf == 0 || milled.insert(take.copyOf).second))
            path.sources.push_back({take.id});
    if (path.sources.empty()) return withoutTake();
    const Result<std::vector<StoredPath>> others = project.paths();
    if (!others) return others.error();
    path.name = "path " + std::to_string(others->size() + 1);
    path.edits = standardEdits();
    const Result<Tool> tool = toolFor(project, toolId);
    if (tool && !tool->cutter.turns()) path.edits = forFixedTool(std::move(path.edits));
    return path;
}

Result<std::vector<StoredPath>> jobPaths(Project& project) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const Result<std::vector<SourceInfo>> standing = standingSources(project);
    if (!standing) return standing.error();
    const Result<std::vector<StoredPath>> kept = project.paths();
    if (!kept) return kept.error();
    const auto recorded = [&](const std::string& tool) {
        return std::ranges::any_of(*standing,
                                   [&](const SourceInfo& each) { return each.source.isTake() && each.toolId == tool; });
    };
    std::vector<StoredPath> paths;
    for (const std::string& tool : toolsOf(*standing)) {
        const auto first =
            std::ranges::find_if(*kept, [&](const StoredPath& path) { return toolOf(path, *sources) == tool; });
        if (first != kept->end()) {
            paths.push_back(*first);
            continue;
        }
        if (!recorded(tool)) continue; // generated moves that belong to no path
        Result<StoredPath> made = standardPath(project, tool);
        if (!made) return std::move(made).error();
        const Result<std::int64_t> id = project.addPath(*made);
        if (!id) return id.error();
        made->id = *id;
        paths.push_back(std::move(*made));
    }
    if (paths.empty()) return withoutTake();
    return paths;
}

Result<PathMatter> matterOf(const Project& project, const StoredPath& path) {
    Result<std::vector<SourceStrokes>> strokes = strokesOf(project, path);
    if (!strokes) return std::move(strokes).error();
    if (strokes->empty()) return withoutTake();
    Result<Tool> tool = toolFor(project, strokes->front().info.toolId);
    if (!tool) return std::move(tool).error();
    return PathMatter{path, std::move(*strokes), std::move(*tool), nullptr};
}

Result<PathMatter> outlinedMatterOf(const Project& project, const StoredPath& path) {
    const Result<std::vector<SourceInfo>> known = sourcesOf(project);
    if (!known) return known.error();
    std::vector<SourceStrokes> sources;
    for (const PathSource source : path.sources)
        if (const auto info = std::ranges::find(*known, source, &SourceInfo::source); info != known->end())
            sources.push_back({*info, {}});
    if (sources.empty()) return withoutTake();
    Result<Tool> tool = toolFor(project, sources.front().info.toolId);
    if (!tool) return std::move(tool).error();
    return PathMatter{path, std::move(sources), std::move(*tool), nullptr};
}

bool areEvaluated(const std::vector<PathMatter>& matters) {
    std::vector<MilledPath> milled;
    for (const std::size_t place : milledOrder(matters)) {
        const PathMatter& matter = matters[place];
        if (!matter.evaluated || !comesAfter(*matter.evaluated, milled)) return false;
        milled.push_back({matter.evaluated, matter.tool});
    }
    return true;
}

Result<EvaluatedPaths> evaluateInOrder(const MillingContext& milling, std::vector<PathMatter> matters,
                                       Progress& progress) {
    const std::vector<std::size_t> order = milledOrder(matters);
    const Result<std::vector<MilledPath>> milled = evaluateEach(milling, std::move(matters), order, progress);
    if (!milled) return milled.error();
    EvaluatedPaths done;
    for (const MilledPath& each : *milled) {
        const EvaluatedPath& path = *each.evaluated;
        done.program.paths.push_back(path.path);
        done.reports.insert(done.reports.end(), path.reports.begin(), path.reports.end());
        done.errorBudget = std::max(done.errorBudget, path.errorBudget);
        if (std::ranges::find(done.program.tools, each.tool.id, &Tool::id) == done.program.tools.end())
            done.program.tools.push_back(each.tool);
    }
    return done;
}

namespace {

/// The paths of the job, with one path replacing the one of its tool.
struct JobMatters {
    std::vector<PathMatter> matters; ///< in the order in which their tools first milled
    std::size_t itself = 0;          ///< index of that path
};

/// @param path if it has no sources, it has no strokes @param tool id of its tool
Result<PathMatter> matterOfOwn(const Project& project, const StoredPath& path, const std::string& tool) {
    if (!path.sources.empty()) return matterOf(project, path);
    const Result<Tool> known = toolFor(project, tool);
    if (!known) return known.error();
    return PathMatter{path, {}, *known, nullptr};
}

Result<JobMatters> mattersOfJob(const Project& project, const StoredPath& path, const std::string& tool) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const Result<std::vector<SourceInfo>> standing = standingSources(project);
    if (!standing) return standing.error();
    const std::vector<std::string> millingTools = toolsOf(*standing);
    std::vector<StoredPath> milled = byFirstTake(firstPaths(*paths, *sources), *sources, millingTools);
    std::erase_if(milled, [&](const StoredPath& each) {
        const std::string other = toolOf(each, *sources);
        return other != tool && std::ranges::find(millingTools, other) == millingTools.end();
    });
    const auto own = std::ranges::find(milled, tool, [&](const StoredPath& each) { return toolOf(each, *sources); });
    JobMatters job{{}, static_cast<std::size_t>(own - milled.begin())};
    if (own == milled.end()) milled.push_back(path);
    for (std::size_t i = 0; i < milled.size(); ++i) {
        Result<PathMatter> matter = i == job.itself ? matterOfOwn(project, path, tool) : matterOf(project, milled[i]);
        if (!matter) return std::move(matter).error();
        job.matters.push_back(std::move(*matter));
    }
    return job;
}

} // namespace

Result<EvaluatedPath> evaluateInJob(const Project& project, const MillingContext& milling, const StoredPath& path,
                                    Progress& progress) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const std::string tool = toolOf(path, *sources);
    if (tool.empty()) return withoutTake();
    Result<JobMatters> job = mattersOfJob(project, path, tool);
    if (!job) return std::move(job).error();
    std::vector<std::size_t> order = milledOrder(job->matters);
    order.erase(std::ranges::find(order, job->itself) + 1, order.end());
    const Result<std::vector<MilledPath>> milled = evaluateEach(milling, std::move(job->matters), order, progress);
    if (!milled) return milled.error();
    return *milled->back().evaluated;
}

Result<std::vector<PathMatter>> pathsBefore(const Project& project, const StoredPath& path, const SourceInfo& next) {
    Result<JobMatters> job = mattersOfJob(project, path, next.toolId);
    if (!job) return std::move(job).error();
    PathMatter& own = job->matters[job->itself];
    own.sources.push_back({next, {}}); // it affects the order
    const std::vector<std::size_t> order = milledOrder(job->matters);
    own.sources.pop_back();
    std::vector<PathMatter> before;
    for (const std::size_t place : order) {
        const bool itself = place == job->itself;
        if (!itself || !path.sources.empty()) before.push_back(std::move(job->matters[place]));
        if (itself) break;
    }
    return before;
}

Result<void> lendStockBehind(const MillingContext& milling, std::vector<PathMatter> paths, const StockUse& use,
                             Progress& progress) {
    std::vector<std::size_t> order(paths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Result<std::vector<MilledPath>> milled = [&] {
        const ProgressPart part(progress, 0.0, 0.8);
        return evaluateEach(milling, std::move(paths), order, progress);
    }();
    if (!milled) return std::move(milled).error();
    const ProgressPart part(progress, 0.8, 1.0);
    return milling.stock->lend(*milled, use, progress);
}

Result<std::vector<Path>> promisedPaths(const Project& project, const MillingContext& milling, Progress& progress) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    std::vector<PathMatter> matters;
    std::vector<StoredPath> variants;
    for (StoredPath path : *paths) {
        if (toolOf(path, *sources).empty()) continue;
        addNewerTakes(path, *sources); // as programs are posted
        if (!isFirstOfItsTool(path, *paths, *sources)) {
            variants.push_back(std::move(path));
            continue;
        }
        Result<PathMatter> matter = matterOf(project, path);
        if (!matter) return std::move(matter).error();
        matters.push_back(std::move(*matter));
    }
    if (matters.empty()) return std::vector<Path>{};
    Result<EvaluatedPaths> job = evaluateInOrder(milling, std::move(matters), progress);
    if (!job && job.error().code != ErrorCode::pathEmpty) return std::move(job).error();
    std::vector<Path> promised;
    if (job) promised = std::move(job->program.paths);
    for (const StoredPath& variant : variants) {
        Result<EvaluatedPath> evaluated = evaluateInJob(project, milling, variant, progress);
        if (!evaluated && evaluated.error().code != ErrorCode::pathEmpty) return std::move(evaluated).error();
        if (evaluated) promised.push_back(std::move(evaluated->path));
    }
    return promised;
}

} // namespace burin
