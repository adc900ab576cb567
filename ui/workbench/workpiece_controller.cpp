// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/workpiece_controller.h"

#include "core/exchange/volume_output.h"
#include "core/job/milling_materials.h"
#include "core/machine/machine_library.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/tool_controller.h"

#include <QCoreApplication>

#include <utility>

namespace burin {

namespace {

/// A workpiece after the cuts of its recordings, and the number of strokes in effect of each.
struct ReplayedMilling {
    std::shared_ptr<MillingContext> milling;
    std::map<std::int64_t, std::size_t> strokes;
};

/// A material as the text of its file; empty if it is not among them.
std::string textOf(const std::vector<Property>& materials, const std::string& id) {
    const auto found = std::ranges::find(materials, id, &Property::id);
    return found == materials.end() ? std::string() : toJson(*found);
}

} // namespace

void WorkpieceController::setRequested(std::shared_ptr<const Model> model, const Setup& setup,
                                       const std::vector<Property>& materials, const Tool& tool) {
    const bool otherTool = tool.id != tool_.id;
    model_ = std::move(model);
    setup_ = setup;
    materials_ = materials;
    tool_ = tool;
    if (otherTool && milling_) buildBounds();
    if (otherMaterials()) changeMaterials();
    if (otherZero()) changeZero();
    emit changed();
}

/// Whether only the program zero of the workpiece differs from the settings.
bool WorkpieceController::otherZero() const {
    return embedded() && milling_->model == model_ &&
           (milling_->setup.zero != setup_.zero || milling_->setup.workOffset != setup_.workOffset);
}

/// The workpiece is kept; the position of the machine's travel is updated, and how a control interprets the coordinates
/// of a path.
void WorkpieceController::changeZero() {
    emit surroundingsChanged();
    desk_.tasks.abandon(TaskKind::field);
    letGo([this] {
        if (!otherZero()) return; // changed again meanwhile
        milling_->setup.zero = setup_.zero;
        milling_->setup.workOffset = setup_.workOffset;
        buildBounds();
    });
}

/// Whether only the materials of the workpiece, or their values, differ from the settings.
bool WorkpieceController::otherMaterials() const {
    if (!milling_ || milling_->model != model_ || !shapedAlike(milling_->setup, setup_)) return false;
    if (!embedded()) return true;
    return std::ranges::any_of(materialsUsed(setup_), [this](const std::string& id) {
        return textOf(materials_, id) != textOf(milling_->materials, id);
    });
}

/// The workpiece is kept, and so are the bounds, which don't depend on materials; feeds and speeds of paths do.
void WorkpieceController::changeMaterials() {
    emit surroundingsChanged();
    letGo([this] {
        if (!otherMaterials()) return; // changed again meanwhile
        if (const Result<void> done = burin::changeMaterials(*milling_, setup_, materials_); !done) {
            emit failed(done.error());
            return;
        }
        strokes_.clear(); // they belong to the previous volume
        emit workpieceChanged();
        emit toolChanged();
    });
}

void WorkpieceController::setRequested(const RequestedBounds& bounds) {
    const RequestedBounds before = std::exchange(wanted_, bounds);
    if (!milling_) return;
    if (before.obstacles != bounds.obstacles || before.travel.zero != bounds.travel.zero) emit surroundingsChanged();
    if (boundAlike(before, bounds)) {
        if (before.obstacles != bounds.obstacles) switchObstacles();
        return;
    }
    // The height above which travel is free, and thus the allowed tip positions, depend on the workpiece.
    desk_.tasks.abandon(TaskKind::field);
    letGo([this] {
        if (!milling_) return;
        milling_->obstacles = obstaclesOf(wanted_.obstacles);
        milling_->travel = wanted_.travel;
        buildBounds();
    });
}

/// A session has layers of its own.
void WorkpieceController::switchObstacles() {
    stopReaders([this] {
        if (milling_ && milling_->obstacles.size() == wanted_.obstacles.size())
            for (std::size_t i = 0; i < wanted_.obstacles.size(); ++i)
                milling_->obstacles[i].on = wanted_.obstacles[i].on;
        goOn();
    });
}

void WorkpieceController::setRequested(const MachineProfile& machine) {
    if (toJson(machine) == toJson(machine_)) return; // its values may have changed under the same id
    machine_ = machine;
    if (!milling_) return;
    emit machineChanged();
    desk_.tasks.abandon(TaskKind::field);
    letGo([this] {
        if (!milling_) return;
        milling_->machine = machine_;
        buildBounds();
    });
}

std::shared_ptr<const ClearanceField> WorkpieceController::field() const {
    if (!bounds_ || bounds_->field() == nullptr) return nullptr;
    return {bounds_, bounds_->field()}; // shares ownership of the bounds
}

bool WorkpieceController::embedded() const {
    return milling_ && model_ && embedAlike(milling_->setup, setup_);
}

bool WorkpieceController::ready() const {
    return embedded() && bounds_ && !embedding();
}

void WorkpieceController::exportTo(const std::filesystem::path& file) {
    if (!embedded()) return;
    desk_.tasks.start(
        TaskKind::exporting, tr("Exporting the workpiece"),
        [file, milling = milling_, workpiece = milling_->embedded.workpiece.snapshot()](Progress& progress) {
            return writeAnyVolume(file, workpiece, progress);
        },
        [this](const Result<WrittenVolume>& written) {
            if (written)
                emit exported(QString::fromStdString(written->file));
            else if (written.error().code != ErrorCode::cancelled)
                emit failed(written.error());
            emit changed();
        });
    emit changed();
}

void WorkpieceController::clear() {
    ++generation_;
    reading_ = false;
    desk_.tasks.abandon(TaskKind::embedding);
    desk_.tasks.abandon(TaskKind::field);
    desk_.tasks.abandon(TaskKind::growth);
    desk_.tasks.abandon(TaskKind::touching);
    touchable_.reset();
    touchableModel_.reset();
    milling_.reset();
    bounds_.reset();
    strokes_.clear();
    emit workpieceChanged();
    emit changed();
}

void WorkpieceController::embed() {
    if (model_ && !embedding()) readWork(&WorkpieceController::embedWith);
}

/// A run started before used the previous state of the recordings.
void WorkpieceController::remake() {
    const bool first = !embedded();
    if (first && !embedding()) return;
    ++generation_;
    desk_.tasks.abandon(TaskKind::embedding);
    readWork(first ? &WorkpieceController::embedWith : &WorkpieceController::remakeWith);
}

void WorkpieceController::readWork(void (WorkpieceController::*then)(const RecordedWork&), bool fromKept) {
    reading_ = true;
    emit changed();
    desk_.project.ask([fromKept](Project& project) { return recordedWork(project, fromKept); },
                      [this, then, generation = generation_](Result<RecordedWork> work) {
                          if (generation != generation_) return; // those of another project or setup
                          reading_ = false;
                          if (work)
                              (this->*then)(*work);
                          else
                              emit failed(work.error());
                          emit changed();
                      });
}

void WorkpieceController::remakeWith(const RecordedWork& work) {
    struct Remade {
        std::shared_ptr<RunVolume> workpiece;
        std::map<std::int64_t, std::size_t> strokes;
    };
    desk_.tasks.start(
        TaskKind::embedding, tr("Milling the takes again"),
        [work, stock = milling_->stock,
         like = VolumeKind{milling_->embedded.workpiece.grid(), milling_->embedded.workpiece.properties()}](
            Progress& progress) -> Result<Remade> {
            Result<RunVolume> workpiece = workpieceOf(
                work, [&] { return stock->makeStock(progress); }, progress, like);
            if (!workpiece) return std::move(workpiece).error();
            return Remade{std::make_shared<RunVolume>(std::move(*workpiece)), work.strokes};
        },
        [this, milling = milling_, fromKept = work.kept.has_value()](const Result<Remade>& outcome) {
            if (!outcome) {
                if (fromKept && outcome.error().code == ErrorCode::fileDamaged)
                    return readWork(&WorkpieceController::remakeWith, false);
                emit changed();
                emit failed(outcome.error());
                return;
            }
            letGo([this, milling, made = *outcome, generation = generation_] {
                if (generation != generation_ || milling != milling_) return;
                milling_->embedded.workpiece = std::move(*made.workpiece);
                strokes_.clear(); // they belong to the previous volume
                emit workpieceChanged();
                emit replayed(made.strokes);
                emit changed();
            });
        });
    emit changed();
}

void WorkpieceController::embedWith(const RecordedWork& work) {
    MillingContextRequest request{model_,        setup_, tool_, machine_.id, materials_, obstaclesOf(wanted_.obstacles),
                                  wanted_.travel};
    desk_.tasks.start(
        TaskKind::embedding, tr("Embedding the part"),
        [request = std::move(request), work](Progress& progress) -> Result<ReplayedMilling> {
            Result<MillingContext> milling = makeMillingContext(request, progress);
            if (!milling) return std::move(milling).error();
            progress.stage(0.0, 1.0);
            if (Result<void> replayed = replayTakes(work, *milling, progress); !replayed) return replayed.error();
            return ReplayedMilling{std::make_shared<MillingContext>(std::move(*milling)), work.strokes};
        },
        [this, fromKept = work.kept.has_value()](Result<ReplayedMilling> outcome) {
            if (!outcome) {
                if (fromKept && outcome.error().code == ErrorCode::fileDamaged)
                    return readWork(&WorkpieceController::embedWith, false);
                emit changed();
                emit failed(outcome.error());
                return;
            }
            letGo([this, made = *outcome, generation = generation_] {
                if (generation != generation_) return; // it was cleared while milling released it
                adopt(made.milling);
                emit replayed(made.strokes);
            });
        });
    emit changed();
}

void WorkpieceController::adopt(std::shared_ptr<MillingContext> milling) {
    bounds_.reset();
    strokes_.clear();
    milling_ = std::move(milling);
    emit workpieceChanged();
    emit toolChanged();
    milling_->obstacles = obstaclesOf(wanted_.obstacles);
    milling_->travel = wanted_.travel;
    buildBounds();
    emit changed();
}

void WorkpieceController::buildBounds() {
    desk_.tasks.start(
        TaskKind::field,
        tr("Computing the boundary for %1").arg(QCoreApplication::translate("Resource", tool_.name.c_str())),
        [milling = milling_, tool = tool_, wanted = wanted_,
         stock = touchable()](Progress& progress) -> Result<std::shared_ptr<const ToolBounds>> {
            TravelPlacement travel = wanted.travel;
            travel.on = true; // sessions switch it as a layer
            // Shares ownership of the workpiece.
            const std::shared_ptr<const MeshDistance> part(milling, &milling->part);
            Result<ToolBounds> bounds =
                ToolBounds::grow(*milling, part, tool, wanted.axis, surroundingsOf(*milling, travel, wanted.axis),
                                 maximumAllowance, {}, progress);
            if (!bounds) return std::move(bounds).error();
            bounds->addStock(stock);
            if (!stock && TouchableStock::isQuick(milling->setup))
                if (Result<TouchableStock> made = TouchableStock::of(*milling->model, milling->setup, progress))
                    bounds->addStock(std::make_shared<const TouchableStock>(std::move(*made)));
            return std::make_shared<const ToolBounds>(std::move(*bounds));
        },
        [this, milling = milling_, tool = tool_, wanted = wanted_](Result<std::shared_ptr<const ToolBounds>> outcome) {
            if (!outcome) {
                emit changed();
                emit failed(outcome.error());
            } else if (milling == milling_) {
                letGo([this, tool, wanted, bounds = *outcome] { adoptBounds(tool, wanted, bounds); });
            }
        });
    emit changed();
}

void WorkpieceController::adoptBounds(const Tool& tool, const RequestedBounds& wanted,
                                      std::shared_ptr<const ToolBounds> bounds) {
    if (!milling_) return;
    const PropertyList& properties = milling_->embedded.workpiece.properties();
    const Result<CuttingConditions> conditions =
        cuttingConditions(tool, properties[milling_->embedded.stockProperty], milling_->machine.maximumSpindleSpeed,
                          milling_->machine.maximumFeed);
    if (!conditions) {
        emit failed(conditions.error());
        return;
    }
    milling_->tool = tool;
    milling_->conditions = *conditions;
    bounds_ = std::move(bounds);
    keepTouchable();
    bound_ = wanted;
    emit toolChanged();
    emit changed();
}

/// The tool can mill meanwhile: it is held where the boundary is not made yet.
void WorkpieceController::watchGrowth() {
    if (!bounds_ || bounds_->complete()) return;
    desk_.tasks.start(
        TaskKind::growth, tr("Computing the boundary around the tool"),
        [bounds = bounds_](Progress& progress) { return bounds->waitUntilQuiet(progress); },
        [this](const Result<void>& quiet) {
            if (!quiet && quiet.error().code != ErrorCode::cancelled) emit failed(quiet.error());
            emit changed();
        });
}

/// Stops background tasks, which must not read the workpiece while it changes.
void WorkpieceController::stopReaders(std::function<void()> then) {
    ++changes_;
    emit readersStop();
    desk_.tasks.abandon(TaskKind::growth);
    desk_.tasks.abandon(TaskKind::planning);
    desk_.tasks.abandon(TaskKind::path);
    desk_.tasks.abandon(TaskKind::pass);
    desk_.tasks.abandon(TaskKind::program);
    desk_.tasks.whenIdle(std::move(then));
}

void WorkpieceController::goOn() {
    --changes_;
    if (!changing()) watchGrowth();
    emit readersGoOn();
    emit changed(); // operations that need an unchanging workpiece are possible again
}

void WorkpieceController::letGo(std::function<void()> then) {
    stopReaders([this, then = std::move(then)] {
        const auto change = [this, then] {
            then();
            goOn();
        };
        if (guard_)
            guard_(change);
        else
            change();
    });
}

} // namespace burin
