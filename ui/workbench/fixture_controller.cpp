// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/fixture_controller.h"

#include "core/base/units.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/fixture_solid.h"
#include "ui/messages/messages.h"
#include "ui/workbench/undo_refusal.h"

#include <cmath>
#include <utility>

namespace burin {

FixtureController::FixtureController(const Desk& desk, WorkpieceController& workpiece, StockSolidController& stock,
                                     SurroundingsController& surroundings, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), stock_(stock), surroundings_(surroundings) {
    connect(&stock, &Controller::changed, this, [this] {
        if (placing()) refresh();
    });
    connect(&surroundings, &Controller::changed, this, &FixtureController::follow);
}

bool FixtureController::possible() const {
    return workpiece_.hasModel() && !surroundings_.locked();
}

/// The fixtures of the setup, except the one that is being changed.
std::vector<Obstacle> FixtureController::others() const {
    std::vector<Obstacle> others;
    for (std::size_t i = 0; i < surroundings_.obstacles().size(); ++i) {
        const Obstacle& one = *surroundings_.obstacles()[i].obstacle;
        if (i != instead_ && one.design) others.push_back({one.name, {}, 0.0, true, one.kind, one.design});
    }
    return others;
}

FixtureSite FixtureController::site() const {
    return siteOf(stock_.stock(), others());
}

void FixtureController::begin() {
    if (!possible()) return;
    instead_.reset();
    changed_.reset();
    design_.emplace();
    chooseKind(last_);
}

void FixtureController::beginChange(std::size_t place) {
    if (!possible() || place >= surroundings_.obstacles().size()) return;
    const std::shared_ptr<const Obstacle>& fixture = surroundings_.obstacles()[place].obstacle;
    if (!fixture->design) return;
    instead_ = place;
    changed_ = fixture;
    design_ = fixture->design;
    given_.clear();
    refresh();
}

void FixtureController::cancel() {
    if (!placing()) return;
    design_.reset();
    instead_.reset();
    changed_.reset();
    preview_.reset();
    problem_.reset();
    nextPoint_.reset();
    acceptsOnceJudged_ = false;
    for (const TaskKind kind : {TaskKind::fixturePlacing, TaskKind::fixtureJudging})
        if (desk_.tasks.running(kind)) desk_.tasks.abandon(kind);
    emit changed();
}

void FixtureController::accept() {
    if (!placing() || !possible() || refusedDuringUndo(desk_, *this, SurroundingsController::tr("new fixture"))) return;
    const bool placed = !desk_.tasks.running(TaskKind::fixturePlacing);
    if (placed && !judged_ && !desk_.tasks.running(TaskKind::fixtureJudging)) refresh(); // that was cancelled
    acceptsOnceJudged_ = !placed || !judged_;
    if (acceptsOnceJudged_ || problem_) return;
    last_ = design_->kind;
    const Obstacle fixture = *preview_;
    const std::optional<std::size_t> instead = instead_;
    cancel();
    if (instead)
        surroundings_.change(*instead, fixture);
    else
        surroundings_.add(fixture);
}

void FixtureController::chooseKind(FixtureKind kind) {
    if (!placing() || instead_) return;
    design_ = standardFixture(kind);
    given_.clear();
    placeAt(firstPoint(kind, workpiece_.wantedStock()));
}

void FixtureController::placeAt(const glm::dvec3& point) {
    if (!placing()) return;
    acceptsOnceJudged_ = false;
    nextPoint_.reset();
    if (desk_.tasks.running(TaskKind::fixturePlacing)) {
        nextPoint_ = point;
        return;
    }
    const bool atOnce = stock_.ask(
        TaskKind::fixturePlacing,
        [design = *design_, given = given_, others = others(), point](const StockSolid& stock) {
            return placedAt(design, given, siteOf(stock, others), point);
        },
        [this, before = *design_](const FixtureDesign& placed) {
            if (!placing()) return;
            if (*design_ == before) { // otherwise it was moved or changed meanwhile
                design_ = placed;
                design_->turn = std::remainder(placed.turn, 2.0 * pi);
                refresh();
            }
            if (nextPoint_) placeAt(*nextPoint_);
        });
    if (!atOnce) refresh();
}

void FixtureController::setValue(std::size_t parameter, double value) {
    if (!placing()) return;
    acceptsOnceJudged_ = false;
    design_->values[parameter] = value;
    given_.insert(rowOf(design_->kind).parameters[parameter].key);
    refresh();
}

void FixtureController::setPlace(const glm::dvec3& place) {
    if (!placing()) return;
    acceptsOnceJudged_ = false;
    design_->place = place;
    refresh();
}

void FixtureController::setTurn(double turn) {
    if (!placing()) return;
    acceptsOnceJudged_ = false;
    design_->turn = std::remainder(turn, 2.0 * pi);
    refresh();
}

std::string FixtureController::name() const {
    return changed_ ? changed_->name : surroundings_.freeName(Messages::text(rowOf(design_->kind).title)).toStdString();
}

double FixtureController::margin() const {
    return changed_ ? changed_->margin : SurroundingsController::fixtureMargin;
}

/// Another project was loaded, or the fixture that is being changed was changed or deleted by an undo.
void FixtureController::follow() {
    if (!placing()) return;
    const bool gone = instead_ && (*instead_ >= surroundings_.obstacles().size() ||
                                   surroundings_.obstacles()[*instead_].obstacle != changed_);
    if (gone || !possible()) cancel();
}

/// A fixture in the stock is shown, too.
void FixtureController::refresh() {
    problem_.reset();
    preview_.reset();
    gap_ = 0.0;
    judged_ = false;
    if (desk_.tasks.running(TaskKind::fixtureJudging)) desk_.tasks.abandon(TaskKind::fixtureJudging);
    if (const Result<void> usable = checkFixture(*design_); !usable) {
        problem_ = usable.error();
        judged_ = true;
    } else {
        Obstacle shown{name(), meshOf(*design_), margin(), true, {}, design_};
        if (changed_) {
            shown.kind = changed_->kind;
            shown.on = changed_->on;
        }
        preview_ = std::make_shared<const Obstacle>(std::move(shown));
        judge();
    }
    emit changed();
}

void FixtureController::judge() {
    const auto asking = std::make_shared<bool>(true);
    stock_.ask(
        TaskKind::fixtureJudging, [design = *design_](const StockSolid& stock) { return fitOf(design, stock); },
        [this, design = *design_, asking](const FixtureFit& fit) {
            if (!placing() || *design_ != design) return;
            take(fit);
            if (*asking) return; // `refresh` goes on
            emit changed();
            if (acceptsOnceJudged_) accept();
        });
    *asking = false;
}

void FixtureController::take(const FixtureFit& fit) {
    judged_ = true;
    gap_ = fit.gap;
    if (fit.depth > 0.0) problem_ = inStock(name(), fit.depth);
}

} // namespace burin
