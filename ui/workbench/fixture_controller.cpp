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
    emit changed();
}

void FixtureController::accept() {
    if (!placing() || !possible() || refusedDuringUndo(desk_, *this, SurroundingsController::tr("new fixture"))) return;
    refresh(); // the stock may have changed
    if (problem_) return;
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
    design_ = placedAt(*std::move(design_), given_, site(), point);
    setTurn(design_->turn);
}

void FixtureController::setValue(std::size_t parameter, double value) {
    if (!placing()) return;
    design_->values[parameter] = value;
    given_.insert(rowOf(design_->kind).parameters[parameter].key);
    refresh();
}

void FixtureController::setPlace(const glm::dvec3& place) {
    if (!placing()) return;
    design_->place = place;
    refresh();
}

void FixtureController::setTurn(double turn) {
    if (!placing()) return;
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
    const Result<Obstacle> fixture = fixtureOf(*design_, stock_.stock(), name(), margin());
    if (!fixture) problem_ = fixture.error();
    if (fixture) gap_ = gapTo(*design_, stock_.stock()).value_or(0.0);
    if (fixture || fixture.error().code == ErrorCode::fixtureInStock) {
        Obstacle shown = fixture ? *fixture : Obstacle{name(), meshOf(*design_), margin(), true, {}, design_};
        if (changed_) {
            shown.kind = changed_->kind;
            shown.on = changed_->on;
        }
        preview_ = std::make_shared<const Obstacle>(std::move(shown));
    }
    emit changed();
}

} // namespace burin
