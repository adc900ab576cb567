// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/history.h"

#include "ui/workbench/undo_refusal.h"

#include <memory>
#include <utility>

namespace burin {

/// Passes undo and redo on to the history, which carries them out in order.
class History::Entry final : public QUndoCommand {
public:
    enum class Kind : std::uint8_t {
        value,   ///< stored through Controller::store
        forming, ///< the same, of part or stock
        done,    ///< changes the project by itself
        step     ///< reads the project again
    };
    /// @param change null: a step
    Entry(History& history, Kind kind, QUndoCommand* change)
        : history_(history), kind_(kind), change_(change), before_(history.present()) {
        if (change_) setText(change_->text());
    }
    /// @param stored what the project has stored of the change
    Entry(History& history, QUndoCommand* change, SharedStep stored) : Entry(history, Kind::value, change) {
        step_ = std::move(stored);
        isStored_ = true;
    }
    Entry(History& history, const QString& title, SharedStep step, WorkState before)
        : QUndoCommand(title)
        , history_(history)
        , kind_(Kind::step)
        , step_(std::move(step))
        , before_(std::move(before)) {}
    ~Entry() override;

    int id() const override { return change_ ? change_->id() : -1; }
    void redo() override {
        if (std::exchange(made_, true)) {
            history_.request(*this, false);
            return;
        }
        if (change_) make(false);
        after_ = history_.present();
    }
    void undo() override { history_.request(*this, true); }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = static_cast<const Entry*>(next); // same id: all entries of the stack are of this type
        if (later->before_.setup != before_.setup || !change_->mergeWith(later->change_.get())) return false;
        history_.project_.join(step_, later->step_);
        after_ = later->after_;
        return true;
    }

    void make(bool undo) {
        const auto change = [this, undo] { undo ? change_->undo() : change_->redo(); };
        if (kind_ == Kind::done || std::exchange(isStored_, false))
            change();
        else
            history_.project_.follow(step_, change);
    }
    void noteWorkpiece(const WorkState& later) {
        if (later.setup == after_.setup && later.embedded) after_.embedded = true;
    }
    bool isStep() const noexcept { return kind_ == Kind::step; }
    bool needsRest() const noexcept { return kind_ == Kind::step || kind_ == Kind::forming; }
    const SharedStep& step() const noexcept { return step_; }
    /// The state from which it is undone or redone.
    const WorkState& from(bool undo) const noexcept { return undo ? after_ : before_; }
    const WorkState& to(bool undo) const noexcept { return undo ? before_ : after_; }

    std::int64_t take = 0; ///< of whose recording it is the first entry; 0: none

private:
    History& history_;
    Kind kind_;
    std::unique_ptr<QUndoCommand> change_;
    SharedStep step_;
    WorkState before_, after_;
    bool made_ = false;
    bool isStored_ = false; ///< `step_` holds already what making it changes
};

History::Entry::~Entry() = default;

void History::push(QUndoCommand* change) {
    add(new Entry(*this, Entry::Kind::value, change));
}

void History::pushStored(QUndoCommand* change, const SharedStep& step) {
    addMade(new Entry(*this, change, step));
}

void History::pushForming(QUndoCommand* change) {
    add(new Entry(*this, Entry::Kind::forming, change));
}

/// While the project is being read again, a change of what is shown would be lost, and what it was made of may be about
/// to be undone: it is refused.
void History::add(Entry* entry) {
    if (!busy()) return put(entry);
    const std::unique_ptr<Entry> refused(entry);
    emit project_.failed(undoUnderWay(refused->text()));
}

/// A workpiece that was made after the newest entry belongs to the state that this one leads to.
void History::put(Entry* entry) {
    auto* newest = dynamic_cast<Entry*>(const_cast<QUndoCommand*>(command(index() - 1))); // it was made here
    if (newest != nullptr) newest->noteWorkpiece(entry->from(false));
    parts_.clear(); // entries that were undone are deleted
    QUndoStack::push(entry);
}

void History::pushDone(QUndoCommand* change) {
    addMade(new Entry(*this, Entry::Kind::done, change));
}

void History::pushRecorded(QUndoCommand* change, std::int64_t take) {
    auto* entry = new Entry(*this, Entry::Kind::done, change);
    if (!holdsRecording(take)) entry->take = take;
    addMade(entry);
}

void History::pushStep(const QString& title, const SharedStep& step, const WorkState& before) {
    addMade(new Entry(*this, title, step, before));
}

void History::makeStep(const QString& title, const std::function<void()>& change) {
    const WorkState before = present();
    const SharedStep step;
    project_.follow(step, change);
    pushStep(title, step, before);
}

/// A stroke that ends while the session is being ended comes before what was to be undone.
void History::addMade(Entry* entry) {
    if (resting_) fail();
    if (busy())
        waiting_.push_back(entry);
    else
        put(entry);
}

void History::clear() {
    ++generation_;
    queue_.clear();
    current_.reset();
    resting_ = false;
    parts_.clear();
    for (Entry* entry : std::exchange(waiting_, {})) delete entry;
    hidden_.clear();
    QUndoStack::clear();
}

void History::request(Entry& entry, bool undo) {
    if (aligning_) return;
    queue_.push_back({&entry, undo, false});
    workOff();
}

void History::workOff() {
    if (std::exchange(working_, true)) return;
    while (!busy() && !queue_.empty()) {
        current_ = queue_.front();
        queue_.pop_front();
        begin();
    }
    working_ = false;
    if (busy()) return;
    for (Entry* entry : std::exchange(waiting_, {})) put(entry);
    emit settled();
}

void History::begin() {
    if (current_->undo) hideRecording();
    if (!current_->entry->needsRest() || window_.atRest()) return reach();
    resting_ = true;
    window_.rest([this, generation = generation_] {
        if (generation != generation_) return;
        resting_ = false;
        reach();
    });
}

/// A recording whose strokes are all undone must not keep what was done before it from being undone.
void History::hideRecording() {
    const auto* above = dynamic_cast<const Entry*>(command(placeOf(current_->entry) + 1));
    if (above != nullptr && above->take != 0 && hidden_.insert(above->take).second) window_.hideTake(above->take, true);
}

/// Makes the setup of the entry the one in use.
void History::reach() {
    const auto& [entry, undo, restoring] = *current_;
    if (entry->isStep() || present().setup == entry->from(undo).setup) return make();
    window_.go(entry->from(undo), std::nullopt, [this, generation = generation_](bool reached) {
        if (generation != generation_) return;
        reached ? make() : fail();
    });
}

void History::make() {
    const auto [entry, undo, restoring] = *current_;
    if (!undo && hidden_.erase(entry->take) > 0) window_.hideTake(entry->take, false);
    if (!entry->isStep()) {
        entry->make(undo);
        if (entry->to(undo).embedded) window_.embed();
        return finish();
    }
    window_.go(entry->to(undo), entry->step(), [this, generation = generation_](bool made) {
        if (generation != generation_) return;
        made ? finish() : fail();
    });
}

void History::finish() {
    const Request finished = *std::exchange(current_, std::nullopt);
    const bool goesOn = !parts_.empty() && parts_.back().undo == finished.undo &&
                        placeOf(parts_.back().entry) == placeOf(finished.entry);
    if (!goesOn) parts_.clear();
    if (!finished.restoring) parts_.push_back(finished);
    workOff();
}

/// The parts of a macro that were made before the one that failed are made undone again: the macro stands as a whole
/// where the list says that it does.
void History::fail() {
    const Request failed = *std::exchange(current_, std::nullopt);
    ++generation_;
    resting_ = false;
    queue_.clear();
    const int place = placeOf(failed.entry);
    const std::vector<Request> parts = std::exchange(parts_, {});
    if (failed.restoring) return workOff(); // the list says already what was to be restored
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
        if (placeOf(part->entry) == place && part->undo == failed.undo)
            queue_.push_back({part->entry, !part->undo, true});
    aligning_ = true;
    setIndex(failed.undo ? place + 1 : place);
    aligning_ = false;
    workOff();
}

/// Of an entry, or of the macro that it is a part of.
int History::placeOf(const Entry* entry) const {
    const auto isPartOf = [entry](const QUndoCommand& macro) {
        for (int i = 0; i < macro.childCount(); ++i)
            if (macro.child(i) == entry) return true;
        return false;
    };
    for (int place = 0; place < count(); ++place)
        if (command(place) == entry || isPartOf(*command(place))) return place;
    return -1;
}

bool History::holdsRecording(std::int64_t take) const {
    for (int place = 0; place < index(); ++place)
        if (const auto* entry = dynamic_cast<const Entry*>(command(place)); entry != nullptr && entry->take == take)
            return true;
    return false;
}

} // namespace burin
