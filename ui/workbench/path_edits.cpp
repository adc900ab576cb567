// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Changing the edits of the path in force.
#include "core/path/edit_step.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/undo_refusal.h"
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

/// The last index that the order of edits allows; the end if none does, so that evaluation reports the error.
std::size_t placeFor(const std::vector<Edit>& edits, const Edit& edit) {
    for (std::size_t place = edits.size() + 1; place-- > 0;)
        if (checkOrder(withEdit(edits, place, edit))) return place;
    return edits.size();
}

/// An edit with its interval and moments set to the selection.
Edit meantFor(Edit edit, const SourceInterval& chosen) {
    for (const EditField& field : fieldsOf(edit.parameters)) {
        if (std::holds_alternative<SourceInterval>(field.value)) setField(edit.parameters, field.key, chosen);
        if (std::holds_alternative<Moment>(field.value))
            setField(edit.parameters, field.key, Moment{chosen.source, chosen.first});
    }
    return edit;
}

} // namespace

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
    if (refusedDuringUndo(desk_, *this, tr("new edit"))) return path->edits.size(); // none
    const std::size_t place = placeFor(path->edits, edit);
    push(tr("new edit"), withEdit(path->edits, place, selection_ ? meantFor(edit, *selection_) : edit));
    return place;
}

void PathController::movePlace(const Moment& moment, const glm::dvec3& by, MovePoints::Along along) {
    const StoredPath* path = stored();
    if (path == nullptr || by == glm::dvec3(0.0)) return;
    const SourceInterval interval{moment.source, moment.tick, moment.tick};
    std::vector<Edit> edits = path->edits;
    const auto same = std::ranges::find_if(edits, [&](const Edit& edit) {
        const auto* moves = std::get_if<MovePoints>(&edit.parameters);
        return moves != nullptr && edit.enabled && moves->interval == interval && moves->along == along;
    });
    if (same != edits.end()) {
        std::get<MovePoints>(same->parameters).by += by;
    } else {
        MovePoints moves;
        moves.interval = interval;
        moves.by = by;
        moves.along = along;
        edits = withEdit(edits, placeFor(edits, {moves}), {moves});
    }
    push(tr("point of the path"), std::move(edits));
}

void PathController::insertPoint(const InsertPoint& edit) {
    const StoredPath* path = stored();
    if (path == nullptr || edit.at.source == 0 || refusedDuringUndo(desk_, *this, tr("inserted point"))) return;
    selection_ = SourceInterval{edit.at.source, edit.at.tick, edit.at.tick};
    pointed_.reset();
    push(tr("inserted point"), withEdit(path->edits, placeFor(path->edits, {edit}), {edit}));
    emit changed();
}

void PathController::moveInserted(std::size_t index, const glm::dvec3& by) {
    const StoredPath* path = stored();
    if (path == nullptr || index >= path->edits.size() || by == glm::dvec3(0.0)) return;
    std::vector<Edit> edits = path->edits;
    auto* inserted = std::get_if<InsertPoint>(&edits[index].parameters);
    if (inserted == nullptr) return;
    inserted->by += by;
    push(tr("point of the path"), std::move(edits));
}

void PathController::replaceSelection(const std::vector<glm::dvec3>& places) {
    const StoredPath* path = stored();
    if (path == nullptr || !selection_ || places.size() < 2) return;
    ReplaceInterval replaces;
    replaces.interval = *selection_;
    replaces.places = places;
    push(tr("drawn stroke"), withEdit(path->edits, placeFor(path->edits, {replaces}), {replaces}));
}

void PathController::removeEdit(std::size_t index) {
    const StoredPath* path = stored();
    if (path == nullptr || index >= path->edits.size()) return;
    std::vector<Edit> edits = path->edits;
    edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(index));
    push(tr("deletion of an edit"), std::move(edits));
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
    updateJob();
    evaluation_.touch(id);
    countVersion();
    evaluate();
}

} // namespace burin
