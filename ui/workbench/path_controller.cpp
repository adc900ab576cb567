// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/path_controller.h"

#include "core/job/computed_pass.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// Makes a path of all recordings of each tool and stores it in the project.
Result<std::vector<StoredPath>> makeStandard(Project& project, const std::vector<std::string>& tools) {
    std::vector<StoredPath> made;
    for (const std::string& tool : tools) {
        Result<StoredPath> path = standardPath(project, tool);
        if (!path) return path.error();
        const Result<std::int64_t> id = project.addPath(*path);
        if (!id) return id.error();
        path->id = *id;
        made.push_back(std::move(*path));
    }
    return made;
}

} // namespace

PathController::PathController(const Desk& desk, WorkpieceController& workpiece, const ToolController& tools,
                               QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), tools_(tools), evaluation_(desk, workpiece, this) {
    connect(&evaluation_, &JobEvaluation::changed, this, &Controller::changed);
    connect(&evaluation_, &JobEvaluation::evaluatedAnew, this, [this](qint64 path) {
        if (path == inForce())
            emit evaluatedAnew();
        else
            emit othersChanged();
    });
    connect(&evaluation_, &JobEvaluation::firstResult, this, &PathController::firstResult);
    connect(&evaluation_, &JobEvaluation::recordingsAdded, this, &PathController::keepTakes);
}

void PathController::load(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes,
                          const std::vector<GeneratedInfo>& generated) {
    paths_ = paths;
    standing_ = takes;
    generated_ = generated;
    sources_ = sourcesOf(takes, generated);
    newestStrokes_.clear();
    ++loads_;
    making_ = false;
    dropChoice();
    notMade_.reset();
    evaluation_.forget();
    updateJob();
    countVersion();
    emit evaluatedAnew();
    emit othersChanged();
    emit changed();
}

/// Passes the paths and their order of milling to the evaluation.
void PathController::updateJob() {
    const std::vector<StoredPath> paths = jobPaths();
    evaluation_.setJob(paths, inForce());
    for (const StoredPath& path : paths) {
        RecordedKey key = recordedKey(toolOf(path.id));
        for (const PathSource source : path.sources)
            if (source.isGenerated()) key.emplace_back(source.id, 0, true, 0);
        evaluation_.setRecorded(path.id, key);
    }
}

void PathController::countVersion() {
    version_ = ++newestVersion_;
    versions_ = {{recordedKey({}), version_}};
    emit versionChanged();
}

void PathController::useTool(const std::string& id) {
    if (id == tool_) return;
    tool_ = id;
    dropChoice();
    notMade_.reset();
    updateJob();
    emit evaluatedAnew();
    emit othersChanged();
    emit changed();
    evaluate();
}

std::int64_t PathController::inForce() const {
    const StoredPath* path = stored();
    return path != nullptr ? path->id : 0;
}

std::optional<Error> PathController::problem() const {
    return notMade_ ? notMade_ : evaluation_.problem(inForce());
}

std::shared_ptr<const EvaluatedPath> PathController::current(std::int64_t path) const {
    return evaluation_.isCurrent(path) ? evaluation_.evaluated(path) : nullptr;
}

std::vector<std::shared_ptr<const EvaluatedPath>> PathController::others() const {
    return evaluation_.allBut(inForce());
}

std::vector<std::string> PathController::toolsMissingBefore() const {
    std::vector<std::string> tools;
    for (const std::int64_t path : evaluation_.missingBefore(inForce())) tools.push_back(toolOf(path));
    return tools;
}

const StoredPath* PathController::stored() const {
    return hasTakes() ? pathOf(tool_) : nullptr;
}

std::vector<StoredPath> PathController::jobPaths() const {
    std::vector<StoredPath> paths = firstPaths(paths_, sources_);
    std::erase_if(paths, [&](const StoredPath& path) { return !isMilledWith(toolOf(path.id)); });
    return inMillingOrder(paths, sources_, toolsThatMilled(), tools_.tools());
}

std::string PathController::toolOf(std::int64_t path) const {
    const auto found = std::ranges::find(paths_, path, &StoredPath::id);
    return found == paths_.end() ? std::string() : burin::toolOf(*found, sources_);
}

std::vector<std::string> PathController::toolsThatMilled() const {
    return toolsOf(sourcesOf(standing_, generatedInUse()));
}

std::vector<std::string> PathController::toolsWithoutPath() const {
    std::vector<std::string> tools = toolsOf(sourcesOf(standing_, {}));
    std::erase_if(tools, [this](const std::string& tool) { return pathOf(tool) != nullptr; });
    return tools;
}

bool PathController::hasTakes() const {
    return isMilledWith(tool_);
}

bool PathController::isMilledWith(const std::string& tool) const {
    const std::vector<std::string> tools = toolsThatMilled();
    return std::ranges::find(tools, tool) != tools.end();
}

/// Passes whose path was undone are kept for redo and are not in use meanwhile.
std::vector<GeneratedInfo> PathController::generatedInUse() const {
    std::vector<GeneratedInfo> used = generated_;
    std::erase_if(used, [&](const GeneratedInfo& pass) {
        return std::ranges::none_of(paths_, [&](const StoredPath& path) {
            return std::ranges::find(path.sources, PathSource{pass.id}) != path.sources.end();
        });
    });
    return used;
}

void PathController::takesChanged(const std::vector<TakeInfo>& all, const std::vector<TakeInfo>& standing,
                                  const std::map<std::int64_t, std::uint64_t>& newestStrokes) {
    sources_ = sourcesOf(all, generated_);
    standing_ = standing;
    newestStrokes_ = newestStrokes;
    updateJob();
    // New recordings are evaluated on request; an evaluation under way includes the newest ones.
    if (!evaluation_.busy(inForce())) evaluation_.hold();
    followRecordings();
    emit changed();
}

void PathController::forgetTake(std::int64_t take) {
    bool used = false;
    for (StoredPath& path : paths_) used = std::erase(path.sources, PathSource{take}) > 0 || used;
    if (!used) return;
    dropChoice();
    updateJob();
    countVersion();
    emit changed();
}

void PathController::recordingBegins() {
    evaluation_.hold();
}

/// @param tool id; empty: all tools
RecordedKey PathController::recordedKey(const std::string& tool) const {
    RecordedKey key;
    for (const TakeInfo& take : standing_) {
        if (!tool.empty() && take.toolId != tool) continue;
        if (take.copyOf != 0 && !isMilled(take.id)) continue;
        const auto newest = newestStrokes_.find(take.id);
        key.emplace_back(take.id, take.sampleCount - take.undoneCount, take.complete,
                         newest != newestStrokes_.end() ? newest->second : 0);
    }
    std::ranges::sort(key); // the order of the takes may change
    return key;
}

/// A program posted before strokes were milled and then undone is up to date again.
void PathController::followRecordings() {
    const auto [known, isNew] = versions_.try_emplace(recordedKey({}), newestVersion_ + 1);
    if (isNew) ++newestVersion_;
    version_ = known->second;
    emit versionChanged();
}

void PathController::workpieceRemade() {
    evaluation_.touchAll();
    countVersion();
    evaluate();
    emit changed();
}

void PathController::makeNew() {
    if (stored() != nullptr) {
        const bool turns = tools_.current().cutter.turns();
        push(tr("new path"), turns ? standardEdits() : forFixedTool(standardEdits()));
        return;
    }
    if (!workpiece_.milling() || making_ || toolsWithoutPath().empty()) return;
    making_ = true;
    desk_.project.postStep(
        [tools = toolsWithoutPath()](Project& project) { return makeStandard(project, tools); },
        [this, load = loads_, tool = tool_](const Result<std::vector<StoredPath>>& paths, const SharedStep& step) {
            if (load != loads_) return; // another project
            making_ = false;
            if (paths) {
                keepNew(*paths, {}, step);
            } else if (tool == tool_) {
                notMade_ = paths.error();
            }
            emit changed();
        });
    emit changed();
}

std::vector<GeneratedInfo> PathController::passes() const {
    std::vector<GeneratedInfo> own;
    if (stored() == nullptr) return own;
    for (const PathSource source : stored()->sources)
        if (const auto found = std::ranges::find(generated_, source.id, &GeneratedInfo::id); found != generated_.end())
            own.push_back(*found);
    return own;
}

void PathController::removePass(std::int64_t id) {
    const StoredPath* path = stored();
    if (path == nullptr) return;
    std::vector<PathSource> left = path->sources;
    if (std::erase(left, PathSource{id}) == 0) return;
    if (left.empty())
        desk_.undo.push(
            new ValueCommand<bool>(tr("deletion of a pass"), -1, true, false,
                                   [this, paths = std::vector{*path}](bool present) { setPresent(paths, present); }));
    else
        desk_.undo.push(new ValueCommand<std::vector<PathSource>>(
            tr("deletion of a pass"), -1, path->sources, std::move(left),
            [this, own = path->id](const std::vector<PathSource>& sources) { applySources(own, sources); }));
}

void PathController::movePassUp(std::int64_t id) {
    const StoredPath* path = stored();
    if (path == nullptr) return;
    const auto found = std::ranges::find(path->sources, PathSource{id});
    if (found == path->sources.end() || found == path->sources.begin()) return;
    Result<std::vector<PathSource>> moved =
        movedSource(path->sources, *found, static_cast<std::size_t>(found - path->sources.begin()) - 1);
    if (!moved) return;
    desk_.undo.push(new ValueCommand<std::vector<PathSource>>(
        tr("order of passes"), -1, path->sources, std::move(*moved),
        [this, own = path->id](const std::vector<PathSource>& sources) { applySources(own, sources); }));
}

void PathController::applySources(std::int64_t id, const std::vector<PathSource>& sources) {
    const auto path = std::ranges::find(paths_, id, &StoredPath::id);
    if (path == paths_.end()) return;
    path->sources = sources;
    dropChoice();
    store([path = *path](Project& project) { return project.setPath(path); });
    updateJob();
    evaluation_.touch(id);
    countVersion();
    evaluate();
    emit changed();
}

void PathController::select(const Moment& moment) {
    selection_ = SourceInterval{moment.source, moment.tick, moment.tick};
    pointed_.reset();
    emit changed();
}

void PathController::pointAt(const Moment& moment) {
    pointed_ = SourceInterval{moment.source, moment.tick, moment.tick};
    emit changed();
}

void PathController::selectTo(const Moment& moment) {
    if (!selection_ || selection_->source != moment.source) {
        select(moment);
        return;
    }
    pointed_.reset();
    selection_->first = std::min(selection_->first, moment.tick);
    selection_->last = std::max(selection_->last, moment.tick);
    emit changed();
}

void PathController::dropChoice() {
    selection_.reset();
    pointed_.reset();
}

void PathController::clearSelection() {
    if (!selection_ && !pointed_) return;
    dropChoice();
    emit changed();
}

void PathController::evaluate() {
    evaluation_.start();
}

/// The project has stored them already, even if the request was replaced meanwhile.
void PathController::keepNew(const std::vector<StoredPath>& paths, const std::vector<GeneratedInfo>& sources,
                             const SharedStep& step) {
    notMade_.reset();
    paths_.insert(paths_.end(), paths.begin(), paths.end());
    desk_.undo.pushStored(new ValueCommand<bool>(tr("new path"), -1, false, true,
                                                 [this, paths, sources](bool present) {
                                                     learn(sources);
                                                     setPresent(paths, present);
                                                 }),
                          step);
}

/// @param paths as they were made: later edits are undone before the paths are removed
void PathController::setPresent(const std::vector<StoredPath>& paths, bool present) {
    for (const StoredPath& path : paths) {
        const auto known = std::ranges::find(paths_, path.id, &StoredPath::id);
        if (present && known == paths_.end()) {
            paths_.push_back(path);
            store([path](Project& project) { return project.restorePath(path); });
        } else if (!present && known != paths_.end()) {
            if (path.id == inForce()) dropChoice();
            paths_.erase(known);
            store([id = path.id](Project& project) { return project.removePath(id); });
        }
    }
    updateJob();
    countVersion();
    emit evaluatedAnew();
    emit othersChanged();
    emit changed();
    evaluate();
}

/// Recordings were added to a path in the project. (The path may have been undone meanwhile.)
void PathController::keepTakes(const StoredPath& path) {
    const auto known = std::ranges::find(paths_, path.id, &StoredPath::id);
    if (known == paths_.end()) return;
    for (const PathSource source : path.sources) // its edits and passes may have changed meanwhile
        if (source.isTake() && std::ranges::find(known->sources, source) == known->sources.end())
            known->sources.push_back(source);
    updateJob();
}

} // namespace burin
