// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/stock_solid_controller.h"

#include "core/setup/fixture_fit.h"

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
    depths_.clear();
    emit changed();
}

const StockSolid& StockSolidController::stock() {
    if (part_ && !asked_) prepare();
    return stock_;
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
                depths_.clear();
            } else if (solid.error().code != ErrorCode::cancelled) {
                emit failed(solid.error());
            }
            emit changed();
        });
}

double StockSolidController::depthOf(const std::shared_ptr<const Obstacle>& fixture) {
    if (!fixture->design) return 0.0;
    const StockSolid& solid = stock();
    std::erase_if(depths_, [](const auto& known) { return known.first.use_count() == 1; }); // deleted for good
    const auto [entry, isNew] = depths_.try_emplace(fixture, 0.0);
    if (isNew) entry->second = depthIn(*fixture->design, solid);
    return entry->second;
}

} // namespace burin
