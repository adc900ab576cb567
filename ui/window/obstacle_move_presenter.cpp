// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/obstacle_move_presenter.h"

#include <utility>

namespace burin {

ObstacleMovePresenter::ObstacleMovePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.mover}, parent), viewport_(viewport) {
    ObstacleMover& mover = workbench.mover;
    connect(&mover, &Controller::changed, this, [this] {
        if (workbench_.mover.moving() == moving_) return;
        moving_ ? end() : begin();
    });
    connect(&placer_, &FixturePlacer::placed, &mover, &ObstacleMover::placeAt);
    connect(&placer_, &FixturePlacer::movedBy, &mover, &ObstacleMover::moveBy);
    connect(&placer_, &FixturePlacer::turnedBy, &mover, &ObstacleMover::turnBy);
    // Queued: the key that ends the move is still being handled by the placer.
    connect(&placer_, &FixturePlacer::accepted, &mover, &ObstacleMover::accept, Qt::QueuedConnection);
    connect(&placer_, &FixturePlacer::cancelled, &mover, &ObstacleMover::cancel, Qt::QueuedConnection);
    connect(&viewport, &Viewport::interactiveToolChanged, this, &ObstacleMovePresenter::followTool);
}

void ObstacleMovePresenter::followTool() {
    const InteractiveTool* tool = viewport_.interactiveTool();
    if (moving_ && tool == nullptr) { // mill mode, which the move ended, has released the pointer
        before_ = nullptr;
        viewport_.setInteractiveTool(&placer_);
    } else if (moving_ && tool != &placer_) {
        before_ = nullptr; // another tool took the pointer
        workbench_.mover.accept();
    } else if (!moving_ && tool == &placer_) { // that tool gave the pointer back, but the move has ended
        viewport_.setInteractiveTool(nullptr);
    }
}

void ObstacleMovePresenter::setShown(JobStep step) {
    if (step != JobStep::stock) workbench_.mover.accept();
}

void ObstacleMovePresenter::begin() {
    moving_ = true;
    workbench_.fixtures.cancel();
    emit movingBegins(
        workbench_.mover.rotates()
            ? tr("Drag the handles, click the stock or the table, or use the arrow keys, Page up and down; R rotates "
                 "it. Enter keeps the new position, Esc the old one.")
            : tr("Drag the arrows, click the stock or the table, or use the arrow keys, Page up and down. R rotates it "
                 "by 90°: the edges of a box stay parallel to the axes. Enter keeps the new position, Esc the old "
                 "one."));
    before_ = workbench_.mill.stylus() == nullptr ? viewport_.interactiveTool() : nullptr; // that of mill mode ends
    viewport_.setInteractiveTool(&placer_);
    viewport_.setFocus();
    present();
    emit escapeChanged();
}

void ObstacleMovePresenter::end() {
    moving_ = false;
    InteractiveTool* before = std::exchange(before_, nullptr);
    if (viewport_.interactiveTool() == &placer_) viewport_.setInteractiveTool(before);
    emit movingEnded();
    emit escapeChanged();
}

void ObstacleMovePresenter::present() {
    if (moving_) placer_.setSite(workbench_.mover.site());
}

} // namespace burin
