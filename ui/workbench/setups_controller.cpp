// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/setups_controller.h"

#include "core/job/setup_title.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <utility>

namespace burin {

SetupsController::SetupsController(const Desk& desk, const Neighbours& neighbours, QObject* parent)
    : Controller(desk, parent), neighbours_(neighbours) {
    connect(&neighbours_.document, &DocumentController::opened, this, &SetupsController::forget);
    connect(&neighbours_.document, &DocumentController::closed, this, &SetupsController::forget);
    // An interrupted task that reads the workpiece is restarted after the change, for example after the bounds are
    // made.
    connect(&neighbours_.workpiece, &WorkpieceController::readersStop, this, [this] {
        if (!again_) return;
        interrupted_ = true;
        desk_.tasks.cancel(TaskKind::furtherSetup);
    });
    connect(&neighbours_.workpiece, &WorkpieceController::readersGoOn, this, [this] {
        if (interrupted_ && again_ && !desk_.tasks.running(TaskKind::furtherSetup)) std::exchange(again_, nullptr)();
    });
    connect(&neighbours_.workpiece, &WorkpieceController::replayed, this, &SetupsController::goOnRetaking);
    connect(&neighbours_.workpiece, &Controller::failed, this, &SetupsController::endRetaking);
    connect(&neighbours_.workpiece, &Controller::changed, this, [this] {
        const WorkpieceController& workpiece = neighbours_.workpiece;
        if (!retaken_ || used_ == retaken_->id) return;
        if (workpiece.embedding()) retaken_->begun = true;
        const bool stopped = !workpiece.embedding() && !workpiece.embedded() && !workpiece.changing();
        if (stopped && retaken_->begun) endRetaking(); // it was cancelled
    });
}

void SetupsController::load(const ProjectContents& contents) {
    setups_ = contents.setups;
    used_ = contents.usedSetup;
    stockOutOfDate_ = contents.stockOutOfDate;
    if (setups_.empty()) setups_.push_back({firstSetup, {}});
    neighbours_.program.setSetupName(setupTitle(setups_, used_));
    emit changed();
}

/// Work under way belongs to the project that was open.
void SetupsController::forget() {
    desk_.tasks.abandon(TaskKind::furtherSetup);
    again_ = nullptr;
    retaken_.reset();
    adding_ = interrupted_ = false;
    ++generation_;
    emit changed();
}

void SetupsController::use(SetupId id) {
    if (id == used_ || adding()) return;
    rest_([this, id] { neighbours_.document.useSetup(id); });
}

void SetupsController::add(const QString& name, const Placement& turn, bool leftStock) {
    if (adding() || !neighbours_.setup.usable()) return;
    if (leftStock && !neighbours_.workpiece.embedded()) return;
    adding_ = true;
    emit changed();
    rest_([this, name, turn, leftStock] {
        if (!leftStock) {
            const Setup& before = neighbours_.setup.setup();
            keep(name, furtherSetup(before, turn, neighbours_.setup.imported(), nullptr));
            return;
        }
        desk_.project.ask(
            [](Project& project) { return project.jobDigest(); },
            [this, name, turn, generation = generation_](const Result<std::int64_t>& digest) {
                if (generation != generation_) return;
                if (!digest) return keep(name, digest.error());
                const Placement to = combined(neighbours_.setup.setup().placement, turn);
                startTask(
                    to, *digest,
                    [turn, model = neighbours_.setup.imported()](const Setup& before, const LeftStock& stock) {
                        return furtherSetup(before, turn, model, &stock);
                    },
                    [this, name](const Result<Setup>& setup) { keep(name, setup); });
            });
    });
}

/// Reads the workpiece, which must be ready, here; the rest takes seconds.
/// @param to placement of the part @param make makes a setup from the one that leaves the stock, and that stock
void SetupsController::startTask(const Placement& to, std::int64_t digest, const MakeSetup& make,
                                 const std::function<void(const Result<Setup>&)>& done) {
    interrupted_ = false;
    again_ = [=, this] { startTask(to, digest, make, done); };
    const std::shared_ptr<MillingContext> milling = neighbours_.workpiece.milling();
    if (!milling || !neighbours_.workpiece.embedded()) {
        again_ = nullptr;
        return done(Error{ErrorCode::cancelled, "setup", {}, {}});
    }
    const VolumeSnapshot recorded = milling->embedded.workpiece.snapshot();
    const auto program = neighbours_.program.exportable() ? neighbours_.program.program() : nullptr;
    desk_.tasks.start(
        TaskKind::furtherSetup, tr("Preparing the stock"),
        [=, by = LeftBy{used_, digest}, name = title(used_).toStdString()](Progress& progress) -> Result<Setup> {
            VolumeSnapshot left = recorded;
            if (program) {
                Result<VolumeSnapshot> machined = leftByProgram(*milling, *program, progress);
                if (!machined) return std::move(machined).error();
                left = std::move(*machined);
            }
            const Result<LeftStock> stock = leftStock(*milling, left, by, to, name, progress);
            return stock ? make(milling->setup, *stock) : Result<Setup>(stock.error());
        },
        [this, done](const Result<Setup>& setup) {
            const bool stopped = !setup && setup.error().code == ErrorCode::cancelled;
            if (stopped && interrupted_) { // readers may continue now, or have continued already
                if (!neighbours_.workpiece.changing() && again_) std::exchange(again_, nullptr)();
                return;
            }
            again_ = nullptr;
            done(setup);
        });
    emit changed();
}

QString SetupsController::title(SetupId id) const {
    const auto own = std::ranges::find(setups_, id, &SetupName::id);
    if (own != setups_.end() && !own->name.empty()) return QString::fromStdString(own->name);
    return tr("Setup %1").arg(numberOf(id));
}

void SetupsController::keep(const QString& name, const Result<Setup>& setup) {
    if (!setup) {
        adding_ = false;
        if (setup.error().code != ErrorCode::cancelled) emit failed(setup.error());
        emit changed();
        return;
    }
    desk_.project.postStep([name = name.toStdString(), setup = *setup, target = neighbours_.target.target()](
                               Project& project) { return storeFurtherSetup(project, name, setup, target); },
                           [this, before = desk_.undo.present()](const Result<SetupId>& id, const SharedStep& step) {
                               if (!id) {
                                   adding_ = false;
                                   emit failed(id.error());
                                   emit changed();
                                   return;
                               }
                               useAfter(tr("further setup"), *id, step, before, [this] { emit added(); });
                           });
}

/// Uses a setup after a step that was made, and adds the step to the undo stack.
void SetupsController::useAfter(const QString& title, SetupId id, const SharedStep& step, const WorkState& before,
                                std::function<void()> then) {
    adding_ = true; // nothing is undone meanwhile
    neighbours_.document.useSetup(id, [this, title, step, before, then = std::move(then)](bool used) {
        adding_ = false;
        if (used) then();
        desk_.undo.pushStep(title, step, before);
        emit changed();
    });
}

void SetupsController::reread(const Result<std::vector<SetupName>>& setups) {
    if (setups)
        setups_ = *setups;
    else
        emit failed(setups.error());
    neighbours_.program.setSetupName(setupTitle(setups_, used_));
    emit changed();
}

void SetupsController::rename(const QString& name) {
    const auto own = std::ranges::find(setups_, used_, &SetupName::id);
    if (own == setups_.end() || own->name == name.toStdString()) return;
    const auto apply = [this, id = used_](const std::string& wanted) {
        desk_.project.post(
            [wanted, id](Project& project) -> Result<std::vector<SetupName>> {
                if (Result<void> named = project.nameSetup(id, wanted); !named) return std::move(named).error();
                return project.setups();
            },
            [this](const Result<std::vector<SetupName>>& setups) { reread(setups); });
    };
    desk_.undo.pushDone(new ValueCommand<std::string>(tr("name of a setup"), -1, own->name, name.toStdString(), apply));
}

void SetupsController::remove() {
    if (setups_.size() < 2 || adding()) return;
    const auto own = std::ranges::find(setups_, used_, &SetupName::id);
    const SetupId other = own == setups_.begin() ? setups_[1].id : std::prev(own)->id;
    rest_([this, other, gone = used_] {
        // It is removed first: if that fails, nothing has changed and it is still shown.
        desk_.project.postStep(
            [other, gone](Project& project) -> Result<void> {
                if (Result<void> used = project.useSetup(other); !used) return used;
                Result<void> removed = project.removeSetup(gone);
                if (removed) return removed;
                static_cast<void>(project.useSetup(gone)); // can't fail: it exists
                return removed;
            },
            [this, other, before = desk_.undo.present()](const Result<void>& removed, const SharedStep& step) {
                if (removed)
                    useAfter(tr("deletion of a setup"), other, step, before, [] {});
                else
                    emit failed(removed.error());
            });
    });
}

/// The workpiece that the other setup leaves is made whenever that setup is used, so this switches there and back.
void SetupsController::takeStockAnew() {
    const Setup& setup = neighbours_.setup.setup();
    if (!setup.leftBy || neighbours_.setup.locked() || adding()) return;
    retaken_ = Retaken{used_, setup, false, desk_.undo.present()};
    emit changed();
    rest_([this, from = setup.leftBy->setup] {
        neighbours_.document.useSetup(from, [this](bool used) {
            if (!used) return endRetaking();
            if (!neighbours_.workpiece.embedding() && !neighbours_.workpiece.embedded()) neighbours_.workpiece.embed();
        });
    });
}

void SetupsController::goOnRetaking() {
    if (!retaken_ || desk_.tasks.running(TaskKind::furtherSetup)) return;
    desk_.project.ask([](Project& project) { return project.jobDigest(); },
                      [this](const Result<std::int64_t>& digest) {
                          if (!retaken_) return;
                          if (!digest) return tellRetaken(digest.error());
                          startTask(
                              retaken_->setup.placement, *digest,
                              [setup = retaken_->setup, model = neighbours_.setup.imported()](
                                  const Setup&, const LeftStock& stock) -> Result<Setup> {
                                  return placeStock(*placed(model, setup.placement), withStock(setup, stock));
                              },
                              [this](const Result<Setup>& setup) { tellRetaken(setup); });
                      });
}

void SetupsController::tellRetaken(const Result<Setup>& setup) {
    if (!retaken_) return;
    if (!setup) {
        if (setup.error().code != ErrorCode::cancelled) emit failed(setup.error());
        return endRetaking();
    }
    desk_.project.postStep(
        [setup = *setup, id = retaken_->id](Project& project) { return project.setSetup(setup, id); },
        [this](const Result<void>& stored, const SharedStep& step) {
            if (!stored) emit failed(stored.error());
            if (stored && retaken_) retaken_->step = step;
            endRetaking();
        });
}

/// Returns to the setup whose stock was taken, with or without success.
void SetupsController::endRetaking() {
    if (!retaken_) return;
    const Retaken retaken = *std::exchange(retaken_, std::nullopt);
    emit changed();
    neighbours_.document.useSetup(retaken.id, [this, retaken](bool used) {
        if (used) emit added();
        if (retaken.step) desk_.undo.pushStep(tr("stock of another setup"), *retaken.step, retaken.before);
    });
}

} // namespace burin
