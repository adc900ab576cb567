// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/bench_controller.h"

#include "core/job/bench_materials.h"
#include "core/machine/machine_library.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/tool_controller.h"

#include <QCoreApplication>

#include <utility>

namespace burin {

namespace {

/// A bench with what its recordings cut, and how many strokes stand in each of them.
struct ReplayedBench {
    std::shared_ptr<Bench> bench;
    std::map<std::int64_t, std::size_t> strokes;
};

} // namespace

void BenchController::setWanted(std::shared_ptr<const Model> model, const Setup& setup,
                                const std::vector<Property>& materials, const Tool& tool) {
    const bool otherTool = tool.id != tool_.id;
    model_ = std::move(model);
    setup_ = setup;
    materials_ = materials;
    tool_ = tool;
    if (otherTool && bench_) buildBounds();
    if (bench_ && bench_->model == model_ && !embedded() && shapedAlike(bench_->setup, setup_)) changeMaterials();
    emit changed();
}

/// The workpiece stays, and so do the bounds, which know no material.
void BenchController::changeMaterials() {
    letGo([this] {
        if (!bench_ || embedded() || !shapedAlike(bench_->setup, setup_)) return; // changed again meanwhile
        if (const Result<void> done = burin::changeMaterials(*bench_, setup_, materials_); !done) {
            emit failed(done.error());
            return;
        }
        strokes_.clear(); // of the volume that was
        emit workpieceChanged();
        emit toolChanged();
    });
}

void BenchController::setWanted(const WantedBounds& bounds) {
    const WantedBounds before = std::exchange(wanted_, bounds);
    if (!bench_) return;
    if (before.obstacles != bounds.obstacles || before.travel.zero != bounds.travel.zero) emit surroundingsChanged();
    if (boundAlike(before, bounds)) {
        if (before.obstacles != bounds.obstacles) switchObstacles();
        return;
    }
    // How high travel is free, and so where a tip may go, is the bench's to say.
    desk_.tasks.abandon(TaskKind::field);
    letGo([this] {
        if (!bench_) return;
        bench_->obstacles = obstaclesOf(wanted_.obstacles);
        bench_->travel = wanted_.travel;
        buildBounds();
    });
}

/// A session has layers of its own.
void BenchController::switchObstacles() {
    stopReaders([this] {
        if (bench_ && bench_->obstacles.size() == wanted_.obstacles.size())
            for (std::size_t i = 0; i < wanted_.obstacles.size(); ++i)
                bench_->obstacles[i].on = wanted_.obstacles[i].on;
        goOn();
    });
}

void BenchController::setWanted(const MachineProfile& machine) {
    if (toJson(machine) == toJson(machine_)) return; // its values may have changed under the same id
    machine_ = machine;
    if (!bench_) return;
    emit machineChanged();
    desk_.tasks.abandon(TaskKind::field);
    letGo([this] {
        if (!bench_) return;
        bench_->machine = machine_;
        buildBounds();
    });
}

std::shared_ptr<const ClearanceField> BenchController::field() const {
    if (!bounds_ || bounds_->field() == nullptr) return nullptr;
    return {bounds_, bounds_->field()}; // it goes with the bounds
}

bool BenchController::embedded() const {
    return bench_ && model_ && embedAlike(bench_->setup, setup_);
}

bool BenchController::ready() const {
    return embedded() && bounds_ && !embedding();
}

void BenchController::clear() {
    desk_.tasks.abandon(TaskKind::embedding);
    desk_.tasks.abandon(TaskKind::field);
    desk_.tasks.abandon(TaskKind::growth);
    bench_.reset();
    bounds_.reset();
    strokes_.clear();
    emit workpieceChanged();
    emit changed();
}

void BenchController::embed() {
    if (!model_ || embedding()) return;
    reading_ = true;
    emit changed();
    desk_.project.ask([](Project& project) { return cutsOf(project); },
                      [this](Result<std::vector<RecordedCuts>> takes) {
                          reading_ = false;
                          if (takes)
                              embedWith(std::move(*takes));
                          else
                              emit failed(takes.error());
                          emit changed();
                      });
}

void BenchController::embedWith(std::vector<RecordedCuts> takes) {
    BenchRequest request{model_,        setup_, tool_, machine_.id, materials_, obstaclesOf(wanted_.obstacles),
                         wanted_.travel};
    desk_.tasks.start(
        TaskKind::embedding, tr("Embedding the part"),
        [request = std::move(request), takes = std::move(takes)](Progress& progress) -> Result<ReplayedBench> {
            Result<Bench> bench = makeBench(request, progress);
            if (!bench) return std::move(bench).error();
            progress.stage(0.0, 1.0);
            if (Result<void> replayed = replayTakes(takes, *bench, progress); !replayed) return replayed.error();
            ReplayedBench made{std::make_shared<Bench>(std::move(*bench)), {}};
            for (const RecordedCuts& take : takes) made.strokes[take.take] = take.strokes;
            return made;
        },
        [this](Result<ReplayedBench> outcome) {
            if (!outcome) {
                emit changed();
                emit failed(outcome.error());
                return;
            }
            letGo([this, made = *outcome] {
                adopt(made.bench);
                emit replayed(made.strokes);
            });
        });
    emit changed();
}

void BenchController::adopt(std::shared_ptr<Bench> bench) {
    bounds_.reset();
    strokes_.clear();
    bench_ = std::move(bench);
    emit workpieceChanged();
    emit toolChanged();
    bench_->obstacles = obstaclesOf(wanted_.obstacles);
    bench_->travel = wanted_.travel;
    buildBounds();
    emit changed();
}

void BenchController::buildBounds() {
    desk_.tasks.start(
        TaskKind::field,
        tr("Computing the boundary for %1").arg(QCoreApplication::translate("Resource", tool_.name.c_str())),
        [bench = bench_, tool = tool_,
         wanted = wanted_](Progress& progress) -> Result<std::shared_ptr<const ToolBounds>> {
            TravelPlacement travel = wanted.travel;
            travel.on = true;                                                    // it is a layer that sessions switch
            const std::shared_ptr<const MeshDistance> part(bench, &bench->part); // it keeps the bench
            Result<ToolBounds> bounds =
                ToolBounds::grow(*bench, part, tool, wanted.axis, surroundingsOf(*bench, travel, wanted.axis),
                                 maximumAllowance, {}, progress);
            if (!bounds) return std::move(bounds).error();
            return std::make_shared<const ToolBounds>(std::move(*bounds));
        },
        [this, bench = bench_, tool = tool_, wanted = wanted_](Result<std::shared_ptr<const ToolBounds>> outcome) {
            if (!outcome) {
                emit changed();
                emit failed(outcome.error());
            } else if (bench == bench_) {
                letGo([this, tool, wanted, bounds = *outcome] { adoptBounds(tool, wanted, bounds); });
            }
        });
    emit changed();
}

void BenchController::adoptBounds(const Tool& tool, const WantedBounds& wanted,
                                  std::shared_ptr<const ToolBounds> bounds) {
    if (!bench_) return;
    const PropertyList& properties = bench_->embedded.workpiece.properties();
    const Result<CuttingConditions> conditions =
        cuttingConditions(tool, properties[bench_->embedded.stockProperty], bench_->machine.maximumSpindleSpeed,
                          bench_->machine.maximumFeed);
    if (!conditions) {
        emit failed(conditions.error());
        return;
    }
    bench_->tool = tool;
    bench_->conditions = *conditions;
    bounds_ = std::move(bounds);
    bound_ = wanted;
    emit toolChanged();
    emit changed();
}

/// The tool can mill meanwhile: it is held where the boundary is not there yet.
void BenchController::watchGrowth() {
    if (!bounds_ || bounds_->complete()) return;
    desk_.tasks.start(
        TaskKind::growth, tr("Computing the boundary around the tool"),
        [bounds = bounds_](Progress& progress) { return bounds->waitUntilQuiet(progress); },
        [this](const Result<void>& quiet) {
            if (!quiet && quiet.error().code != ErrorCode::cancelled) emit failed(quiet.error());
            emit changed();
        });
}

/// What reads the bench in the background would read it while it changes.
void BenchController::stopReaders(std::function<void()> then) {
    ++changes_;
    emit readersStop();
    desk_.tasks.abandon(TaskKind::growth);
    desk_.tasks.abandon(TaskKind::planning);
    desk_.tasks.abandon(TaskKind::path);
    desk_.tasks.abandon(TaskKind::program);
    desk_.tasks.whenIdle(std::move(then));
}

void BenchController::goOn() {
    --changes_;
    if (!changing()) watchGrowth();
    emit readersGoOn();
    emit changed(); // what needs a bench that stands still may be done again
}

void BenchController::letGo(std::function<void()> then) {
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
