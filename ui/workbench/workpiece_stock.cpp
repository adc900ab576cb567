// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The stock before milling as a layer of the bounds.
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <utility>

namespace burin {

/// The stock of the present workpiece, if it was made before.
std::shared_ptr<const TouchableStock> WorkpieceController::touchable() const {
    const bool same = touchable_ && touchableModel_ == milling_->model && shapedAlike(touchableSetup_, milling_->setup);
    return same ? touchable_ : nullptr;
}

void WorkpieceController::keepTouchable() {
    if (!bounds_->stock()) return;
    touchable_ = bounds_->stock();
    touchableModel_ = milling_->model;
    touchableSetup_ = milling_->setup;
}

bool WorkpieceController::canBringStock() const {
    return bounds_ && !bounds_->stock() && bounds_->layers().size() < ToolBounds::capacity;
}

void WorkpieceController::bringStock(std::function<void()> refused) {
    if (!canBringStock() || desk_.tasks.running(TaskKind::touching)) return;
    desk_.tasks.start(
        TaskKind::touching, tr("Computing the surface of the stock"),
        [milling = milling_](Progress& progress) -> Result<std::shared_ptr<const TouchableStock>> {
            Result<TouchableStock> stock = TouchableStock::of(*milling->model, milling->setup, progress);
            if (!stock) return std::move(stock).error();
            return std::make_shared<const TouchableStock>(std::move(*stock));
        },
        [this, milling = milling_, refused = std::move(refused)](Result<std::shared_ptr<const TouchableStock>> stock) {
            if (!stock) {
                refused();
                if (stock.error().code != ErrorCode::cancelled) emit failed(stock.error());
            } else if (milling == milling_) {
                letGo([this, milling, made = *stock] {
                    if (milling != milling_ || !bounds_) return;
                    auto bounds = std::make_shared<ToolBounds>(*bounds_); // shares what is large
                    bounds->addStock(made);
                    bounds_ = std::move(bounds);
                    keepTouchable();
                    emit changed();
                });
            }
            emit changed();
        });
    emit changed();
}

} // namespace burin
