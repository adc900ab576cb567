// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/fixture_presenter.h"

#include "ui/messages/messages.h"

#include <QAction>

#include <utility>

namespace burin {

namespace {

constexpr int fixtureDialogMargin = 24; // pixels between the dialog and the window's edge

/// The sentence names a size by its label.
QString problemText(const FixtureDesign& design, Error error) {
    if (const std::optional<std::size_t> parameter = indexOf(design.kind, error.subject))
        error.subject = Messages::text(rowOf(design.kind).parameters[*parameter].label).toStdString();
    return Messages::sentence(error);
}

} // namespace

FixturePresenter::FixturePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.fixtures, &workbench.setup}, parent), viewport_(viewport) {
    FixtureController& fixtures = workbench.fixtures;
    connect(&fixtures, &Controller::changed, this, [this] {
        if (workbench_.fixtures.placing() == (dialog_ != nullptr)) return;
        dialog_ == nullptr ? begin() : end();
    });
    connect(&placer_, &FixturePlacer::placed, &fixtures, &FixtureController::placeAt);
    connect(&placer_, &FixturePlacer::movedBy, &fixtures, &FixtureController::moveBy);
    connect(&placer_, &FixturePlacer::turnedBy, &fixtures, &FixtureController::turnBy);
    // Queued: the key that ends placing is still being handled by the placer.
    connect(&placer_, &FixturePlacer::accepted, &fixtures, &FixtureController::accept, Qt::QueuedConnection);
    connect(&placer_, &FixturePlacer::cancelled, &fixtures, &FixtureController::cancel, Qt::QueuedConnection);
    connect(&viewport, &Viewport::interactiveToolChanged, this, [this] {
        const InteractiveTool* tool = viewport_.interactiveTool();
        const bool placer = tool == &placer_;
        if (dialog_ != nullptr && tool == nullptr) { // mill mode, which placing ended, has released the pointer
            before_ = nullptr;
            viewport_.setInteractiveTool(&placer_);
        } else if (dialog_ != nullptr && !placer) {
            before_ = nullptr; // another tool took the pointer
            workbench_.fixtures.cancel();
        } else if (dialog_ == nullptr && placer) { // that tool gave the pointer back, but placing has ended
            viewport_.setInteractiveTool(nullptr);
        }
    });
}

void FixturePresenter::connectActions(const Actions& actions) {
    connect(actions[ActionId::libraryFixture], &QAction::triggered, &workbench_.fixtures, &FixtureController::begin);
}

void FixturePresenter::setShown(JobStep step) {
    if (step != JobStep::stock) workbench_.fixtures.cancel();
}

void FixturePresenter::begin() {
    emit placingBegins();
    FixtureController& fixtures = workbench_.fixtures;
    dialog_ = new FixtureDialog(viewport_.window());
    connect(dialog_, &QDialog::finished, &fixtures, &FixtureController::cancel);
    connect(dialog_, &FixtureDialog::kindChosen, &fixtures, &FixtureController::chooseKind);
    connect(dialog_, &FixtureDialog::valueEdited, &fixtures, &FixtureController::setValue);
    connect(dialog_, &FixtureDialog::placeEdited, &fixtures, &FixtureController::setPlace);
    connect(dialog_, &FixtureDialog::turnEdited, &fixtures, &FixtureController::setTurn);
    connect(dialog_, &FixtureDialog::turnedBy, &fixtures, &FixtureController::turnBy);
    connect(dialog_, &FixtureDialog::acceptRequested, &fixtures, &FixtureController::accept, Qt::QueuedConnection);
    before_ = workbench_.mill.stylus() == nullptr ? viewport_.interactiveTool() : nullptr; // that of mill mode ends
    viewport_.setInteractiveTool(&placer_);
    present();
    // At the edge of the window, so that the stock stays visible.
    dialog_->fit();
    const QRect window = viewport_.window()->geometry();
    dialog_->move(window.right() - dialog_->width() - fixtureDialogMargin, window.top() + fixtureDialogMargin);
    dialog_->show();
    dialog_->fit(); // its rows are styled, and higher, only now
    emit escapeChanged();
}

void FixturePresenter::end() {
    FixtureDialog* dialog = std::exchange(dialog_, nullptr);
    dialog->disconnect();
    dialog->hide();
    dialog->deleteLater();
    InteractiveTool* before = std::exchange(before_, nullptr);
    if (viewport_.interactiveTool() == &placer_) viewport_.setInteractiveTool(before);
    emit escapeChanged();
}

void FixturePresenter::present() {
    if (dialog_ == nullptr) return;
    placer_.setSite(workbench_.fixtures.site());
    dialog_->setState(state());
}

FixtureDialogState FixturePresenter::state() const {
    const FixtureController& fixtures = workbench_.fixtures;
    FixtureDialogState state;
    state.design = fixtures.design();
    state.zero = workbench_.setup.setup().workOffset;
    state.unit = unit();
    state.changing = fixtures.instead().has_value();
    state.gap = fixtures.gap();
    if (fixtures.problem()) state.problem = problemText(state.design, *fixtures.problem());
    return state;
}

} // namespace burin
