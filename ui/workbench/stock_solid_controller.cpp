// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/stock_solid_controller.h"

namespace burin {

StockSolidController::StockSolidController(const Desk& desk, SetupController& setup, QObject* parent)
    : Controller(desk, parent), setup_(setup) {
    connect(&setup, &Controller::changed, this, &StockSolidController::follow);
}

void StockSolidController::follow() {
    const Setup& now = setup_.setup();
    if (part_ == setup_.part() && shapedAlike(of_, now) && of_.stock.low == now.stock.low &&
        of_.stock.high == now.stock.high && of_.cylinder == now.cylinder)
        return;
    desk_.tasks.abandon(TaskKind::stockSolid);
    part_ = setup_.part();
    of_ = now;
    stock_ = part_ ? StockSolid(now.stock) : StockSolid();
    asked_ = false;
    forgetFits();
    emit changed();
}

const StockSolid& StockSolidController::stock() {
    if (part_ && !asked_ && pauses_ == 0) prepare();
    return stock_;
}

void StockSolidController::pause() {
    ++pauses_;
    if (!preparing()) return;
    desk_.tasks.abandon(TaskKind::stockSolid);
    asked_ = false;
}

void StockSolidController::goOn() {
    if (--pauses_ == 0 && part_ && !asked_) emit changed();
}

void StockSolidController::prepare() {
    asked_ = true;
    if (of_.form == StockForm::box) return;
    if (of_.form == StockForm::cylinder) {
        Progress progress;
        if (Result<StockSolid> solid = StockSolid::of(*part_, of_, progress))
            stock_ = *std::move(solid);
        else
            emit failed(solid.error());
        return;
    }
    desk_.tasks.start(
        TaskKind::stockSolid, tr("Preparing the stock for fixtures"),
        [part = part_, setup = of_](Progress& progress) { return StockSolid::of(*part, setup, progress); },
        [this](const Result<StockSolid>& solid) {
            if (solid) {
                stock_ = *solid;
                forgetFits();
            } else if (solid.error().code != ErrorCode::cancelled) {
                emit failed(solid.error());
            }
            emit changed();
        });
}

void StockSolidController::forgetFits() {
    if (desk_.tasks.running(TaskKind::fixtureFit)) desk_.tasks.abandon(TaskKind::fixtureFit);
    fits_.clear();
}

std::optional<FixtureFit> StockSolidController::fitOf(const std::shared_ptr<const Obstacle>& fixture) {
    std::erase_if(fits_, [](const auto& known) { return known.first.use_count() == 1; }); // deleted for good
    const auto known = fits_.find(fixture);
    if (known != fits_.end()) return known->second;
    if (desk_.tasks.running(TaskKind::fixtureFit)) return std::nullopt; // one after the other
    // What is answered at once needs no signal: its caller has the answer.
    const auto asking = std::make_shared<bool>(true);
    const bool atOnce = ask(
        TaskKind::fixtureFit, [fixture](const StockSolid& solid) { return burin::fitOf(*fixture, solid); },
        [this, fixture, asking](const FixtureFit& fit) {
            fits_.insert_or_assign(fixture, fit);
            if (!*asking) emit changed();
        });
    *asking = false;
    return atOnce ? std::optional(fits_.at(fixture)) : std::nullopt;
}

} // namespace burin
