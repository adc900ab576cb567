// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// How takes are noted, named, moved, copied, deleted and switched off.
#include "core/job/take_moves.h"
#include "ui/workbench/done_command.h"
#include "ui/workbench/mill_controller.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <utility>

namespace burin {

/// A recording without strokes counts as well, so that what was done before it can't be undone while it stands.
void MillController::noteRecording() {
    const std::int64_t take = std::exchange(recorded_, 0);
    if (!placeOf(take)) return;
    desk_.undo.pushDone(
        new DoneCommand(tr("take without strokes"), [this, take](bool undo) { emit takeUndone(take, undo); }));
}

void MillController::nameTake(std::int64_t id, const QString& name) {
    const auto take = std::ranges::find(takes_, id, &TakeInfo::id);
    if (take == takes_.end() || name.trimmed().isEmpty() || take->name == name.trimmed().toStdString()) return;
    const auto apply = [this, id](const std::string& wanted) {
        desk_.project.post([id, wanted](Project& project) { return project.nameTake(id, wanted); },
                           [this](const Result<void>& outcome) {
                               if (!outcome) emit failed(outcome.error());
                               refreshTakes();
                           });
    };
    desk_.undo.pushDone(
        new ValueCommand<std::string>(tr("name of a take"), -1, take->name, name.trimmed().toStdString(), apply));
}

void MillController::removeTake(std::int64_t id) {
    changeTake(id, true, [this, id] {
        desk_.undo.pushDone(new DoneCommand(tr("delete a take"), [this, id](bool undo) { changeTake(id, !undo, {}); }));
    });
}

/// @param then called on success
void MillController::changeTake(std::int64_t id, bool remove, const Then& then) {
    desk_.project.post(
        [id, remove](Project& project) { return remove ? project.removeTake(id) : project.restoreTake(id); },
        [this, then](const Result<void>& outcome) {
            if (!outcome) {
                emit failed(outcome.error());
                return;
            }
            workpiece_.remake();
            if (then) then();
            refreshTakes();
        });
}

void MillController::chooseTake(std::int64_t id) {
    if (std::exchange(chosen_, id) != id) emit changed();
}

std::int64_t MillController::chosenTake() const noexcept {
    return placeOf(chosen_) ? chosen_ : 0;
}

std::optional<std::size_t> MillController::placeOf(std::int64_t take) const noexcept {
    const auto found = std::ranges::find(takes_, take, &TakeInfo::id);
    if (found == takes_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - takes_.begin());
}

bool MillController::canMove(std::int64_t take, int by) const noexcept {
    const std::optional<std::size_t> place = placeOf(take);
    return place && canCopy(take) && (by < 0 ? *place > 0 : *place + 1 < takes_.size());
}

bool MillController::canCopy(std::int64_t take) const noexcept {
    return placeOf(take) && !changingTakes() && !recording() && !recordingSince_ && !startingRecording_;
}

void MillController::moveTake(std::int64_t id, int by) {
    if (!canMove(id, by)) return;
    reorder([id, by](const Project& project) -> Result<TakeOrder> {
        const Result<std::vector<TakeInfo>> takes = project.takes(); // the order may have changed since the request
        if (!takes) return takes.error();
        const auto place = std::ranges::find(*takes, id, &TakeInfo::id) - takes->begin() + (by < 0 ? -1 : 1);
        const bool within = place >= 0 && std::cmp_less(place, takes->size());
        return within ? orderWithTakeAt(project, id, static_cast<std::size_t>(place)) : project.takeOrder();
    });
}

void MillController::moveTakeBefore(std::int64_t id, std::int64_t before) {
    if (!canCopy(id) || id == before) return;
    reorder([id, before](const Project& project) -> Result<TakeOrder> {
        const Result<std::vector<TakeInfo>> takes = project.takes();
        if (!takes) return takes.error();
        return std::ranges::find(*takes, before, &TakeInfo::id) != takes->end()
                   ? orderWithTakeBefore(project, id, before)
                   : orderWithTakeAt(project, id, takes->size() - 1);
    });
}

void MillController::countChanges(int by) {
    changesUnderWay_ += by;
    emit changed();
}

/// The workpiece is unchanged, since the takes cut the same in any order. @param wanted called on the project's thread
void MillController::reorder(std::function<Result<TakeOrder>(const Project& project)> wanted) {
    struct Change {
        TakeOrder before, after;
    };
    countChanges(1);
    desk_.project.post(
        [wanted = std::move(wanted)](Project& project) -> Result<Change> {
            Result<TakeOrder> before = project.takeOrder();
            if (!before) return std::move(before).error();
            Result<TakeOrder> after = wanted(project);
            if (!after) return std::move(after).error();
            if (*before != *after)
                if (Result<void> stored = project.setTakeOrder(*after); !stored) return std::move(stored).error();
            return Change{std::move(*before), std::move(*after)};
        },
        [this](const Result<Change>& change) {
            countChanges(-1);
            if (!change) {
                emit failed(change.error());
                return;
            }
            if (change->before == change->after) return;
            desk_.undo.pushDone(new DoneCommand(tr("order of takes"), [this, orders = *change](bool undo) {
                applyOrder(undo ? orders.before : orders.after);
            }));
            refreshTakes();
        });
}

void MillController::applyOrder(const TakeOrder& order) {
    desk_.project.post([order](Project& project) { return project.setTakeOrder(order); },
                       [this](const Result<void>& outcome) {
                           if (!outcome) emit failed(outcome.error());
                           refreshTakes();
                       });
}

/// The workpiece is unchanged, since a copy cuts nothing that its original left.
void MillController::duplicateTake(std::int64_t id) {
    if (!canCopy(id)) return;
    countChanges(1);
    desk_.project.post([id](Project& project) { return project.duplicateTake(id); },
                       [this, id](const Result<std::int64_t>& copy) {
                           countChanges(-1);
                           if (!copy) {
                               emit failed(copy.error());
                               return;
                           }
                           if (const auto strokes = strokes_.find(id); strokes != strokes_.end())
                               strokes_[*copy] = strokes->second;
                           desk_.undo.pushDone(new DoneCommand(
                               tr("copy of a take"), [this, copy = *copy](bool undo) { showCopy(copy, !undo); }));
                           refreshTakes([this, copy = *copy] { chooseTake(copy); });
                       });
}

void MillController::showCopy(std::int64_t id, bool shown) {
    desk_.project.post(
        [id, shown](Project& project) { return shown ? project.restoreTake(id) : project.removeTake(id); },
        [this](const Result<void>& outcome) {
            if (!outcome) emit failed(outcome.error());
            refreshTakes();
        });
}

void MillController::setSwitchedOff(const QString& title, RequestedOff wanted, Then then) {
    struct Change {
        SwitchedOff before, after;
    };
    desk_.project.ask(
        [wanted = std::move(wanted)](Project& project) -> Result<Change> {
            Result<SwitchedOff> after = wanted(project);
            if (!after) return std::move(after).error();
            Result<SwitchedOff> before = switchedOff(project, *after);
            if (!before) return std::move(before).error();
            return Change{std::move(*before), std::move(*after)};
        },
        [this, title, then = std::move(then)](const Result<Change>& change) {
            if (!change) {
                emit failed(change.error());
                return;
            }
            if (change->before == change->after) {
                if (then) then();
                return;
            }
            auto once = std::make_shared<Then>(then);
            desk_.undo.pushDone(new ValueCommand<SwitchedOff>(
                title, -1, change->before, change->after,
                [this, once](const SwitchedOff& off) { applySwitchedOff(off, std::exchange(*once, {})); }));
        });
}

void MillController::applySwitchedOff(const SwitchedOff& off, const Then& then) {
    desk_.project.post([off](Project& project) { return burin::setSwitchedOff(project, off); },
                       [this, then](const Result<void>& outcome) {
                           if (!outcome) {
                               emit failed(outcome.error());
                               return;
                           }
                           // At once, so that nothing uses the present workpiece as the project's new state.
                           workpiece_.remake();
                           refreshTakes(then);
                       });
}

} // namespace burin
