// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/guide_presenter.h"

namespace burin {

GuidePresenter::GuidePresenter(Workbench& workbench, GuidePanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.guides, &workbench.bench, &workbench.mill, &workbench.setup}, parent)
    , panel_(panel) {
    GuideController& guides = workbench.guides;
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&panel, &GuidePanel::guidesToggled, &guides, &GuideController::setOn);
    connect(&panel, &GuidePanel::guideWanted, &guides, &GuideController::add);
    connect(&panel, &GuidePanel::guideEdited, &guides, &GuideController::change);
    connect(&panel, &GuidePanel::guideRemovalRequested, &guides, &GuideController::remove);
    connect(&panel, &GuidePanel::levelStepped, &guides, &GuideController::stepLevel);
    connect(&panel, &GuidePanel::clutchToggled, &guides, &GuideController::setClutched);
    connect(&panel, &GuidePanel::recentreRequested, &guides, &GuideController::recentre);
    connect(&panel, &GuidePanel::scaleEdited, &guides, &GuideController::setScale);
}

void GuidePresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void GuidePresenter::present() {
    const GuideController& guides = workbench_.guides;
    GuideState state;
    state.guides = guides.guides();
    state.on = guides.on();
    state.full = guides.full();
    state.edges = guides.hasEdges();
    state.live = workbench_.mill.active();
    state.hasDevice = guides.hasDevice();
    state.clutched = guides.clutched();
    if (workbench_.bench.bench()) state.zero = workbench_.bench.bench()->setup.workOffset;
    if (state.live) {
        const SessionState& session = workbench_.session.state();
        state.news = session.guides;
        state.scale = session.workspaceScale;
        state.clutched = state.clutched || session.clutched;
    }
    panel_.setState(state);
}

} // namespace burin
