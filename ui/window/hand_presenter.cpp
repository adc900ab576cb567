// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/hand_presenter.h"

namespace burin {

namespace {

constexpr double scaleStep = 1.25; // factor of the hand's scale, by keyboard

/// The direction to the right in the picture, setup frame.
glm::dvec3 rightOf(const Viewport& viewport) {
    const double middle = 0.5 * viewport.height();
    const auto along = [&](double x) { // rays differ in origin in a parallel projection, in direction otherwise
        const ViewportEvent sight = viewport.sight(QPointF(x, middle));
        return sight.rayOrigin + sight.rayDirection;
    };
    return along(viewport.width()) - along(0.0);
}

} // namespace

HandPresenter::HandPresenter(Workbench& workbench, HandPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.hand, &workbench.mill}, parent), panel_(panel) {
    HandController& hand = workbench.hand;
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&panel, &HandPanel::clutchToggled, &hand, &HandController::setClutched);
    connect(&panel, &HandPanel::recentreRequested, &hand, &HandController::recentre);
    connect(&panel, &HandPanel::scaleEdited, &hand, &HandController::setScale);
    connect(&panel, &HandPanel::rateToggled, this, &HandPresenter::setRate);
    connect(&panel, &HandPanel::clutchButtonChosen, &hand, &HandController::setClutchButton);
    connect(&panel, &HandPanel::levelButtonChosen, &hand, &HandController::setLevelButton);
    connect(&panel, &HandPanel::forceButtonChosen, &hand, &HandController::setForceButton);
}

void HandPresenter::connectActions(const Actions& actions, const Viewport& viewport) {
    HandController& hand = workbench_.hand;
    const auto on = [&](ActionId id, auto what) { connect(actions[id], &QAction::triggered, this, what); };
    on(ActionId::clutch, [&hand](bool wanted) { hand.setClutched(wanted); });
    on(ActionId::alignHand, [&hand, &viewport] { hand.alignWith(rightOf(viewport)); });
    on(ActionId::recentre, [&hand] { hand.recentre(); });
    on(ActionId::finerHand, [&hand] { hand.scaleBy(1.0 / scaleStep); });
    on(ActionId::coarserHand, [&hand] { hand.scaleBy(scaleStep); });
    on(ActionId::rateControl, [this](bool wanted) { setRate(wanted); });
    connect(&panel_, &HandPanel::alignmentRequested, actions[ActionId::alignHand], &QAction::trigger);
}

void HandPresenter::setRate(bool on) {
    workbench_.hand.setControl(on ? WorkspaceControl::rate : WorkspaceControl::position);
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
    const StylusDescription& device = hand.device()->description;
    state.motors = device.hasMotors() || device.assist.works();
    state.pushesOnButton = device.assist.forceAxes > 0;
    state.recording = workbench_.mill.recording();
    state.battery = hand.health().batteryShare;
    state.charging = hand.health().charging;
    state.heat = hand.health().motorHeat;
    panel_.setState(state);
}

} // namespace burin
