// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/path_controller.h"

#include "core/path/edit_step.h"
#include "core/project/program_job.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

std::vector<Edit> withEdit(const std::vector<Edit>& edits, std::size_t place, const Edit& edit) {
    std::vector<Edit> more = edits;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(place), edit);
    return more;
}

/// As late as the order of edits allows it; at the end where no place is right, so that evaluation says what is wrong.
std::size_t placeFor(const std::vector<Edit>& edits, const Edit& edit) {
    for (std::size_t place = edits.size() + 1; place-- > 0;)
        if (checkOrder(withEdit(edits, place, edit))) return place;
    return edits.size();
}

/// An edit whose stretch and moments are those that were chosen.
Edit meantFor(Edit edit, const TakeStretch& chosen) {
    for (const EditField& field : fieldsOf(edit.parameters)) {
        if (std::holds_alternative<TakeStretch>(field.value)) setField(edit.parameters, field.key, chosen);
        if (std::holds_alternative<Moment>(field.value))
            setField(edit.parameters, field.key, Moment{chosen.take, chosen.first});
    }
    return edit;
}

bool alike(const StoredPath& one, const StoredPath& other) {
    return one.name == other.name && one.takes == other.takes &&
           std::ranges::equal(one.edits, other.edits,
                              [](const Edit& a, const Edit& b) { return toJson(a) == toJson(b); });
}

/// A path that the project holds just so is left alone: a project that was only opened has no changes.
Result<void> keep(Project& project, StoredPath& path) {
    if (path.id == 0) {
        const Result<std::int64_t> id = project.addPath(path);
        if (!id) return id.error();
        path.id = *id;
        return {};
    }
    const Result<std::vector<StoredPath>> kept = project.paths();
    if (!kept) return kept.error();
    const auto same = std::ranges::find(*kept, path.id, &StoredPath::id);
    if (same != kept->end() && alike(*same, path)) return {};
    return project.setPath(path);
}

/// The path of a tool, or a new one, with what it takes to evaluate it.
Result<PathMatter> gather(Project& project, const std::optional<StoredPath>& stored, const std::string& toolId) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    Result<StoredPath> path = stored ? Result<StoredPath>(*stored) : standardPath(project, toolId);
    if (!path) return std::move(path).error();
    addNewerTakes(*path, *takes);
    if (const Result<void> done = keep(project, *path); !done) return done.error();
    return matterOf(project, *path);
}

} // namespace

PathController::PathController(const Desk& desk, BenchController& bench, QObject* parent)
    : Controller(desk, parent), bench_(bench) {
    connect(&bench_, &BenchController::readersStop, this,
            [this] { interrupted_ = interrupted_ || desk_.tasks.running(TaskKind::path); });
    connect(&bench_, &BenchController::readersGoOn, this, [this] {
        if (!bench_.changing() && std::exchange(interrupted_, false)) evaluate();
    });
}

void PathController::load(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes) {
    paths_ = paths;
    recorded_ = takes;
    ++loads_;
    forgetEvaluation();
    countVersion();
    emit evaluatedAnew();
    emit changed();
}

/// Nothing stands of what was evaluated, nor of what was read for it.
void PathController::forgetEvaluation() {
    desk_.tasks.abandon(TaskKind::path);
    selection_.reset();
    evaluated_.reset();
    problem_.reset();
    matter_.reset();
    interrupted_ = false;
    ++generation_;
    outdated_ = true;
}

void PathController::countVersion() {
    ++version_;
    emit versionChanged();
}

void PathController::useTool(const std::string& id) {
    if (id == tool_) return;
    tool_ = id;
    forgetEvaluation();
    emit evaluatedAnew();
    emit changed();
    if (stored() != nullptr) evaluate();
}

const StoredPath* PathController::stored() const {
    const auto found =
        std::ranges::find_if(paths_, [&](const StoredPath& path) { return burin::toolOf(path, recorded_) == tool_; });
    return found == paths_.end() ? nullptr : &*found;
}

std::vector<StoredPath> PathController::jobPaths() const {
    std::vector<StoredPath> firsts;
    for (const StoredPath& path : paths_)
        if (!toolOf(path.id).empty() && isFirstOfItsTool(path, paths_, recorded_)) firsts.push_back(path);
    return firsts;
}

std::string PathController::toolOf(std::int64_t path) const {
    const auto found = std::ranges::find(paths_, path, &StoredPath::id);
    return found == paths_.end() ? std::string() : burin::toolOf(*found, recorded_);
}

std::vector<std::string> PathController::toolsWithoutPath() const {
    std::vector<std::string> tools;
    for (const TakeInfo& take : recorded_) {
        const bool known = std::ranges::find(tools, take.toolId) != tools.end();
        const bool used = std::ranges::any_of(
            paths_, [&](const StoredPath& path) { return burin::toolOf(path, recorded_) == take.toolId; });
        if (!known && !used) tools.push_back(take.toolId);
    }
    return tools;
}

bool PathController::hasTakes() const {
    return std::ranges::find(recorded_, tool_, &TakeInfo::toolId) != recorded_.end();
}

void PathController::takesChanged(const std::vector<TakeInfo>& takes) {
    recorded_ = takes;
    matter_.reset();
    ++generation_;
    outdated_ = true;
    countVersion();
    emit changed();
}

void PathController::benchChanged() {
    outdated_ = true;
    countVersion();
    if (stored() != nullptr) evaluate();
    emit changed();
}

void PathController::makeNew() {
    if (stored() != nullptr)
        push(tr("new path"), standardEdits());
    else if (bench_.bench() && !reading_)
        readTakes();
}

void PathController::changeEdit(std::size_t index, const Edit& edit) {
    const StoredPath* path = stored();
    if (path == nullptr || index >= path->edits.size()) return;
    std::vector<Edit> edits = path->edits;
    if (toJson(edits[index]) == toJson(edit)) return;
    edits[index] = edit;
    push(tr("change of an edit"), std::move(edits));
}

std::size_t PathController::addEdit(const Edit& edit) {
    const StoredPath* path = stored();
    if (path == nullptr) return 0;
    const std::size_t place = placeFor(path->edits, edit);
    push(tr("new edit"), withEdit(path->edits, place, selection_ ? meantFor(edit, *selection_) : edit));
    return place;
}

void PathController::select(const Moment& moment) {
    selection_ = TakeStretch{moment.take, moment.tick, moment.tick};
    emit changed();
}

void PathController::selectTo(const Moment& moment) {
    if (!selection_ || selection_->take != moment.take) {
        select(moment);
        return;
    }
    selection_->first = std::min(selection_->first, moment.tick);
    selection_->last = std::max(selection_->last, moment.tick);
    emit changed();
}

void PathController::clearSelection() {
    if (!selection_) return;
    selection_.reset();
    emit changed();
}

void PathController::movePlace(const Moment& moment, const glm::dvec3& by, MovePoints::Along along) {
    const StoredPath* path = stored();
    if (path == nullptr || by == glm::dvec3(0.0)) return;
    const TakeStretch stretch{moment.take, moment.tick, moment.tick};
    std::vector<Edit> edits = path->edits;
    const auto same = std::ranges::find_if(edits, [&](const Edit& edit) {
        const auto* moves = std::get_if<MovePoints>(&edit.parameters);
        return moves != nullptr && edit.enabled && moves->stretch == stretch && moves->along == along;
    });
    if (same != edits.end()) {
        std::get<MovePoints>(same->parameters).by += by;
    } else {
        MovePoints moves;
        moves.stretch = stretch;
        moves.by = by;
        moves.along = along;
        edits = withEdit(edits, placeFor(edits, {moves}), {moves});
    }
    push(tr("place of the path"), std::move(edits));
}

void PathController::replaceSelection(const std::vector<glm::dvec3>& places) {
    const StoredPath* path = stored();
    if (path == nullptr || !selection_ || places.size() < 2) return;
    ReplaceStretch replaces;
    replaces.stretch = *selection_;
    replaces.places = places;
    push(tr("drawn stroke"), withEdit(path->edits, placeFor(path->edits, {replaces}), {replaces}));
}

void PathController::removeEdit(std::size_t index) {
    const StoredPath* path = stored();
    if (path == nullptr || index >= path->edits.size()) return;
    std::vector<Edit> edits = path->edits;
    edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(index));
    push(tr("removal of an edit"), std::move(edits));
}

void PathController::moveEdit(std::size_t from, std::size_t to) {
    const StoredPath* path = stored();
    if (path == nullptr || from >= path->edits.size() || to >= path->edits.size() || from == to) return;
    std::vector<Edit> edits = path->edits;
    const Edit moved = edits[from];
    edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(from));
    edits.insert(edits.begin() + static_cast<std::ptrdiff_t>(to), moved);
    push(tr("order of edits"), std::move(edits));
}

void PathController::push(const QString& text, std::vector<Edit> edits) {
    const StoredPath& path = *stored();
    desk_.undo.push(new ValueCommand<std::vector<Edit>>(
        text, -1, path.edits, std::move(edits),
        [this, id = path.id](const std::vector<Edit>& value) { apply(id, value); }));
}

void PathController::apply(std::int64_t id, const std::vector<Edit>& edits) {
    const auto path = std::ranges::find(paths_, id, &StoredPath::id);
    if (path == paths_.end()) return;
    path->edits = edits;
    store([path = *path](Project& project) { return project.setPath(path); });
    countVersion();
    if (&*path != stored()) return;
    outdated_ = true;
    evaluate();
}

void PathController::evaluate() {
    if (!bench_.bench()) return;
    if (matter_)
        evaluateMatter();
    else if (!reading_ && stored() != nullptr)
        readTakes();
}

void PathController::readTakes() {
    reading_ = true;
    const std::optional<StoredPath> path = stored() ? std::optional(*stored()) : std::nullopt;
    desk_.project.post([path, tool = tool_](Project& project) { return gather(project, path, tool); },
                       [this, tool = tool_, project = loads_, generation = generation_](Result<PathMatter> matter) {
                           reading_ = false;
                           if (matter && project == loads_) keepKnown(matter->path);
                           if (generation != generation_) { // recordings or tool changed while they were read
                               if (tool == tool_ || stored() != nullptr) readTakes();
                               return;
                           }
                           if (matter) {
                               take(std::move(*matter));
                               return;
                           }
                           problem_ = matter.error();
                           emit changed();
                       });
    emit changed();
}

/// The project has it, whatever became of the wish for it.
void PathController::keepKnown(const StoredPath& path) {
    const auto same = std::ranges::find(paths_, path.id, &StoredPath::id);
    if (same == paths_.end()) {
        paths_.push_back(path);
        countVersion();
    } else {
        same->takes = path.takes; // its edits may have been changed meanwhile
    }
}

void PathController::take(PathMatter matter) {
    matter_ = std::make_shared<const Recorded>(Recorded{std::move(matter.takes), std::move(matter.tool)});
    evaluateMatter();
}

void PathController::evaluateMatter() {
    const std::shared_ptr<Bench> bench = bench_.bench();
    if (!bench || stored() == nullptr) return;
    if (bench_.changing()) { // evaluated when it has changed
        interrupted_ = true;
        return;
    }
    desk_.tasks.start(
        TaskKind::path, tr("Editing the path"),
        [matter = matter_, bench, path = *stored()](Progress& progress) {
            return evaluateStored(matter->takes, *bench, matter->tool, path, progress);
        },
        [this](Result<EvaluatedPath> outcome) { take(std::move(outcome)); });
    emit changed();
}

void PathController::take(Result<EvaluatedPath> outcome) {
    if (outcome) {
        evaluated_ = std::make_shared<const EvaluatedPath>(std::move(*outcome));
        problem_.reset();
        outdated_ = matter_ == nullptr;
        emit evaluatedAnew();
    } else {
        problem_ = outcome.error();
        outdated_ = true;
    }
    emit changed();
}

} // namespace burin
