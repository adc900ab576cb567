// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/action_states.h"

#include "core/path/drawn_edit.h"

namespace burin {

ActionStates::ActionStates(Actions& actions, Workbench& workbench, QObject* parent)
    : QObject(parent), actions_(actions), workbench_(workbench) {
    for (Controller* controller : workbench.controllers())
        connect(controller, &Controller::changed, this, &ActionStates::update);
    connect(&workbench.path, &PathController::evaluatedAnew, this, &ActionStates::update);
    connect(&workbench.session, &SessionRunner::ticked, this, &ActionStates::update);
    connect(&workbench.undo(), &QUndoStack::indexChanged, this, &ActionStates::update);
    connect(actions[ActionId::undo], &QAction::triggered, &workbench, &Workbench::undoLast);
    connect(actions[ActionId::redo], &QAction::triggered, &workbench, &Workbench::redoLast);
    update();
}

void ActionStates::update() {
    const Workbench& bench = workbench_;
    const bool showing = bench.showMe.showing();
    enable(ActionId::save, bench.document.isOpen());
    enable(ActionId::saveAs, bench.document.isOpen());
    enable(ActionId::exportProgram, bench.program.exportable());
    enable(ActionId::embed, bench.setup.usable() && !bench.setup.locked() && !bench.bench.embedding());
    enable(ActionId::addFixtureFile,
           bench.setup.hasPart() && !bench.surroundings.locked() && !bench.surroundings.importing());
    enable(ActionId::axisOfView, bench.setup.hasPart() && !bench.surroundings.locked());
    enable(ActionId::millMode, bench.bench.ready() && !showing);
    enable(ActionId::raster, bench.bench.ready() && !showing);
    enable(ActionId::showMe, bench.setup.usable() && !showing && !bench.mill.active());
    enable(ActionId::stopShow, showing);
    enable(ActionId::nearestEdge, bench.guides.hasEdges() && !bench.guides.full());
    enable(ActionId::levelAbove, bench.mill.active());
    enable(ActionId::levelBelow, bench.mill.active());
    for (const ActionId id :
         {ActionId::clutch, ActionId::recentre, ActionId::alignHand, ActionId::finerHand, ActionId::coarserHand})
        enable(id, bench.hand.hasDevice());
    enable(ActionId::rateControl, bench.hand.canRate());
    enable(ActionId::newPath,
           (bench.path.hasTakes() || !bench.path.toolsWithoutPath().empty()) && bench.bench.embedded());
    enable(ActionId::evaluatePath, bench.path.stored() != nullptr && bench.bench.embedded());
    enable(ActionId::drawStretch, bench.path.selection().has_value());
    enable(ActionId::drawEdit,
           bench.path.evaluated() && bench.path.stored() != nullptr && lastDrawn(bench.path.stored()->edits));
    enable(ActionId::post, bench.program.postable());
    enable(ActionId::findInProgram, !bench.program.storedText().isEmpty());
    enable(ActionId::overrideCheck, bench.program.refused() && !bench.program.busy());
    enable(ActionId::restart, bench.program.restartable());
    updateUndo();
    actions_[ActionId::millMode]->setChecked(bench.mill.active());
    actions_[ActionId::guides]->setChecked(bench.guides.on());
    actions_[ActionId::clutch]->setChecked(bench.hand.clutched());
    actions_[ActionId::rateControl]->setChecked(bench.hand.canRate() &&
                                                bench.hand.settings().control == WorkspaceControl::rate);
}

void ActionStates::updateUndo() {
    const QUndoStack& stack = workbench_.undo();
    const bool now = workbench_.canUndoNow();
    enable(ActionId::undo, stack.canUndo() && now);
    enable(ActionId::redo, stack.canRedo() && now);
    actions_[ActionId::undo]->setText(stack.canUndo() ? tr("&Undo: %1").arg(stack.undoText()) : tr("&Undo"));
    actions_[ActionId::redo]->setText(stack.canRedo() ? tr("&Redo: %1").arg(stack.redoText()) : tr("&Redo"));
}

} // namespace burin
