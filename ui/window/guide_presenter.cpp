// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/guide_presenter.h"

namespace burin {

GuidePresenter::GuidePresenter(Workbench& workbench, GuidePanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.guides, &workbench.workpiece, &workbench.mill, &workbench.setup}, parent)
    , panel_(panel) {
    GuideController& guides = workbench.guides;
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&panel, &GuidePanel::guidesToggled, &guides, &GuideController::setOn);
    connect(&panel, &GuidePanel::guideRequested, &guides, &GuideController::add);
    connect(&panel, &GuidePanel::guideEdited, &guides, &GuideController::change);
    connect(&panel, &GuidePanel::guideRemovalRequested, &guides, &GuideController::remove);
    connect(&panel, &GuidePanel::levelStepped, &guides, &GuideController::stepLevel);
}

void GuidePresenter::connectActions(const Actions& actions) {
    GuideController& guides = workbench_.guides;
    const auto on = [&](ActionId id, auto what) { connect(actions[id], &QAction::triggered, this, what); };
    on(ActionId::guides, [&guides](bool wanted) { guides.setOn(wanted); });
    on(ActionId::nearestEdge, [&guides] { guides.add(GuideKind::curve); });
    on(ActionId::levelAbove, [&guides] { guides.stepLevel(1); });
    on(ActionId::levelBelow, [&guides] { guides.stepLevel(-1); });
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
    if (workbench_.workpiece.milling()) state.zero = workbench_.workpiece.milling()->setup.workOffset;
    if (state.live) state.news = workbench_.session.state().guides;
    panel_.setState(state);
}

} // namespace burin
