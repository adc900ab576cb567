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

/// Recordings of one tool, and the stored path that has just these.
struct PathMatter {
    StoredPath path;
    std::shared_ptr<const std::vector<Take>> takes;
};

/// The edits with one more, as late as their order allows it; at the end where no place is right, so that evaluation
/// says what is wrong.
std::vector<Edit> withEdit(const std::vector<Edit>& edits, const Edit& edit) {
    for (std::size_t place = edits.size() + 1; place-- > 0;) {
        std::vector<Edit> tried = edits;
        tried.insert(tried.begin() + static_cast<std::ptrdiff_t>(place), edit);
        if (checkOrder(tried)) return tried;
    }
    std::vector<Edit> appended = edits;
    appended.push_back(edit);
    return appended;
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

/// A path has one tool: it takes the recordings that were made with it.
Result<PathMatter> gather(Project& project, const std::optional<StoredPath>& stored, const std::string& toolId) {
    const Result<std::vector<TakeInfo>> infos = project.takes();
    if (!infos) return infos.error();
    PathMatter matter;
    matter.path = stored.value_or(StoredPath{0, "path 1", {}, standardEdits()});
    matter.path.takes.clear();
    std::vector<Take> takes;
    for (const TakeInfo& info : *infos) {
        if (info.toolId != toolId) continue;
        Result<Take> take = project.take(info.id);
        if (!take) return std::move(take).error();
        matter.path.takes.push_back(info.id);
        takes.push_back(std::move(*take));
    }
    if (takes.empty()) return Error{ErrorCode::projectIncomplete, "a recording", "burin mill", {}};
    matter.takes = std::make_shared<const std::vector<Take>>(std::move(takes));
    if (const Result<void> done = keep(project, matter.path); !done) return done.error();
    return matter;
}

} // namespace

PathController::PathController(const Desk& desk, BenchController& bench, QObject* parent)
    : Controller(desk, parent), bench_(bench) {
    connect(&bench_, &BenchController::readersStop, this,
            [this] { interrupted_ = interrupted_ || desk_.tasks.running(TaskKind::path); });
    connect(&bench_, &BenchController::readersGoOn, this, [this] {
        if (std::exchange(interrupted_, false)) evaluate();
    });
}

void PathController::load(const std::vector<StoredPath>& paths) {
    selection_.reset();
    desk_.tasks.abandon(TaskKind::path);
    stored_ = paths.empty() ? std::nullopt : std::optional(paths.front());
    evaluated_.reset();
    problem_.reset();
    takes_.reset();
    interrupted_ = false;
    ++generation_;
    outdated_ = true;
    emit evaluatedAnew();
    emit changed();
}

void PathController::takesChanged() {
    takes_.reset();
    ++generation_;
    outdated_ = true;
    emit changed();
}

void PathController::makeNew() {
    if (stored_) stored_->edits = standardEdits();
    evaluate();
}

void PathController::changeEdit(std::size_t index, const Edit& edit) {
    if (!stored_ || index >= stored_->edits.size()) return;
    std::vector<Edit> edits = stored_->edits;
    if (toJson(edits[index]) == toJson(edit)) return;
    edits[index] = edit;
    push(tr("change of an edit"), std::move(edits));
}

void PathController::addEdit(const Edit& edit) {
    if (!stored_) return;
    push(tr("new edit"), withEdit(stored_->edits, selection_ ? meantFor(edit, *selection_) : edit));
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
    if (!stored_ || by == glm::dvec3(0.0)) return;
    const TakeStretch stretch{moment.take, moment.tick, moment.tick};
    std::vector<Edit> edits = stored_->edits;
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
        edits = withEdit(edits, {moves});
    }
    push(tr("place of the path"), std::move(edits));
}

void PathController::replaceSelection(const std::vector<glm::dvec3>& places) {
    if (!stored_ || !selection_ || places.size() < 2) return;
    ReplaceStretch replaces;
    replaces.stretch = *selection_;
    replaces.places = places;
    push(tr("drawn stroke"), withEdit(stored_->edits, {replaces}));
}

void PathController::removeEdit(std::size_t index) {
    if (!stored_ || index >= stored_->edits.size()) return;
    std::vector<Edit> edits = stored_->edits;
    edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(index));
    push(tr("removal of an edit"), std::move(edits));
}

void PathController::moveEdit(std::size_t from, std::size_t to) {
    if (!stored_ || from >= stored_->edits.size() || to >= stored_->edits.size() || from == to) return;
    std::vector<Edit> edits = stored_->edits;
    const Edit moved = edits[from];
    edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(from));
    edits.insert(edits.begin() + static_cast<std::ptrdiff_t>(to), moved);
    push(tr("order of edits"), std::move(edits));
}

void PathController::push(const QString& text, std::vector<Edit> edits) {
    desk_.undo.push(new ValueCommand<std::vector<Edit>>(text, -1, stored_->edits, std::move(edits),
                                                        [this](const std::vector<Edit>& value) { apply(value); }));
}

void PathController::apply(const std::vector<Edit>& edits) {
    if (!stored_) return;
    stored_->edits = edits;
    store([path = *stored_](Project& project) { return project.setPath(path); });
    outdated_ = true;
    evaluate();
}

void PathController::evaluate() {
    if (!bench_.bench()) return;
    if (takes_ && takesTool_ == bench_.bench()->tool.id)
        evaluateTakes(takes_);
    else if (!reading_)
        readTakes();
}

void PathController::readTakes() {
    reading_ = true;
    const std::string toolId = bench_.bench()->tool.id;
    desk_.project.post([stored = stored_, toolId](Project& project) { return gather(project, stored, toolId); },
                       [this, toolId, generation = generation_](Result<PathMatter> matter) {
                           reading_ = false;
                           if (!matter) {
                               problem_ = matter.error();
                               emit changed();
                               return;
                           }
                           // Edits may have been changed meanwhile.
                           if (stored_) matter->path.edits = stored_->edits;
                           stored_ = std::move(matter->path);
                           if (generation != generation_) { // recordings changed while they were read
                               readTakes();
                               return;
                           }
                           takes_ = std::move(matter->takes);
                           takesTool_ = toolId;
                           evaluateTakes(takes_);
                       });
    emit changed();
}

void PathController::evaluateTakes(const Takes& takes) {
    const std::shared_ptr<Bench> bench = bench_.bench();
    if (!bench || !stored_) return;
    desk_.tasks.start(
        TaskKind::path, tr("Editing the path"),
        [takes, bench, path = *stored_](Progress& progress) { return evaluateStored(*takes, *bench, path, progress); },
        [this](Result<EvaluatedPath> outcome) { take(std::move(outcome)); });
    emit changed();
}

void PathController::take(Result<EvaluatedPath> outcome) {
    if (outcome) {
        evaluated_ = std::make_shared<const EvaluatedPath>(std::move(*outcome));
        problem_.reset();
        outdated_ = takes_ == nullptr;
        emit evaluatedAnew();
    } else {
        problem_ = outcome.error();
        outdated_ = true;
    }
    emit changed();
}

} // namespace burin
