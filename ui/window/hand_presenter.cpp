// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/hand_presenter.h"

namespace burin {

HandPresenter::HandPresenter(Workbench& workbench, HandPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.hand, &workbench.mill}, parent), panel_(panel) {
    HandController& hand = workbench.hand;
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&panel, &HandPanel::clutchToggled, &hand, &HandController::setClutched);
    connect(&panel, &HandPanel::recentreRequested, &hand, &HandController::recentre);
    connect(&panel, &HandPanel::scaleEdited, &hand, &HandController::setScale);
    connect(&panel, &HandPanel::rateToggled, &hand,
            [&hand](bool on) { hand.setControl(on ? WorkspaceControl::rate : WorkspaceControl::position); });
    connect(&panel, &HandPanel::clutchButtonChosen, &hand, &HandController::setClutchButton);
    connect(&panel, &HandPanel::levelButtonChosen, &hand, &HandController::setLevelButton);
    connect(&panel, &HandPanel::forceButtonChosen, &hand, &HandController::setForceButton);
}

void HandPresenter::present() {
    const HandController& hand = workbench_.hand;
    HandState state;
    state.hasDevice = hand.hasDevice() && workbench_.mill.active();
    if (!state.hasDevice) return panel_.setState(state);
    const SessionState& session = workbench_.session.state();
    const HandSettings& settings = hand.settings();
    state.scale = session.workspaceScale;
    state.clutched = hand.clutched() || session.clutched;
    state.canRate = hand.canRate();
    state.rate = state.canRate && settings.control == WorkspaceControl::rate;
    state.buttons = hand.buttons();
    state.clutchButton = settings.clutchButton;
    state.levelButton = settings.levelButton;
    state.forceButton = settings.forceButton;
    state.motors = workbench_.mill.device()->hasMotors();
    state.recording = workbench_.mill.recording();
    state.battery = hand.health().batteryShare;
    state.charging = hand.health().charging;
    state.heat = hand.health().motorHeat;
    panel_.setState(state);
}

} // namespace burin
