// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/action_states.h"

#include "core/passes/plan_pass.h"
#include "core/path/drawn_edit.h"

#include <algorithm>
#include <iterator>

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
    const Workbench& workbench = workbench_;
    const bool showing = workbench.showMe.showing();
    enable(ActionId::save, workbench.document.isOpen());
    enable(ActionId::saveAs, workbench.document.isOpen());
    enable(ActionId::updatePart, workbench.model.model() && !workbench.model.importing() && !workbench.setups.adding());
    enable(ActionId::exportProgram, workbench.program.exportable());
    enable(ActionId::exportWorkpiece,
           workbench.workpiece.embedded() && !workbench.session.running() && !workbench.workpiece.exporting());
    const SetupsController& setups = workbench.setups;
    const auto own = std::ranges::find(setups.setups(), setups.used(), &SetupName::id);
    const bool free = !setups.adding() && !showing;
    enable(ActionId::addSetup, free && workbench.setup.usable() && workbench.workpiece.embedded());
    enable(ActionId::nextSetup, free && own != setups.setups().end() && std::next(own) != setups.setups().end());
    enable(ActionId::previousSetup, free && own != setups.setups().begin());
    for (const ActionId id : {ActionId::faceDown, ActionId::turnAboutX, ActionId::turnAboutY, ActionId::turnAboutZ})
        enable(id, workbench.setup.hasPart() && !workbench.setup.locked() && !workbench.setup.placing() && free);
    enable(ActionId::exportSheet, workbench.setup.usable() && !workbench.sheet.writing());
    enable(ActionId::pickZero, workbench.setup.usable() && free);
    enable(ActionId::holdAtStock, workbench.surroundings.canHoldAtStock() && !showing);
    enable(ActionId::touchZero, workbench.mill.active() && !showing);
    enable(ActionId::embed, workbench.setup.usable() && !workbench.setup.locked() && !workbench.workpiece.embedding());
    enable(ActionId::stockFile,
           workbench.setup.hasPart() && !workbench.setup.locked() && !workbench.setup.readingStock());
    enable(ActionId::tools, !workbench.tool.locked()); // the tool in the spindle must not change
    enable(ActionId::toolShape, !workbench.tool.locked() && !workbench.tool.shaping());
    enable(ActionId::libraryFixture, workbench.fixtures.possible() && workbench.setup.usable() && free);
    enable(ActionId::addFixtureFile,
           workbench.setup.hasPart() && !workbench.surroundings.locked() && !workbench.surroundings.importing());
    enable(ActionId::axisOfView, workbench.setup.hasPart() && !workbench.surroundings.locked());
    enable(ActionId::millMode, workbench.workpiece.ready() && !showing);
    enable(ActionId::raster, workbench.workpiece.ready() && !showing);
    enable(ActionId::showMe,
           workbench.setup.usable() && !showing && !workbench.mill.active() && !workbench.stylusEditor.active());
    enable(ActionId::stopShow, showing);
    enable(ActionId::nearestEdge, workbench.guides.hasEdges() && !workbench.guides.full());
    enable(ActionId::levelAbove, workbench.mill.active());
    enable(ActionId::levelBelow, workbench.mill.active());
    for (const ActionId id :
         {ActionId::clutch, ActionId::recentre, ActionId::alignHand, ActionId::finerHand, ActionId::coarserHand})
        enable(id, workbench.hand.hasDevice());
    enable(ActionId::rateControl, workbench.hand.canRate());
    enable(ActionId::newPath,
           (workbench.path.hasTakes() || !workbench.path.toolsWithoutPath().empty()) && workbench.workpiece.embedded());
    enable(ActionId::programPath, workbench.passes.possible());
    enable(ActionId::measurePasses, workbench.passMeasurer.possible());
    enable(ActionId::refreshPasses, workbench.passRefresher.possible());
    const bool paintable = workbench.workpiece.milling() && !workbench.workpiece.milling()->part.bounds().empty();
    for (const ActionId id : {ActionId::brushArea, ActionId::lassoArea, ActionId::faceArea}) enable(id, paintable);
    enable(ActionId::clearArea, !workbench.area.area().empty());
    const Tool& tool = workbench.tool.current();
    enable(ActionId::newPass, workbench.passes.possible() && tool.cutter.turns());
    enable(ActionId::pickHoles, workbench.passes.possible() && !workbench.mill.active() &&
                                    (mayPlan(PassKind::drill, tool) || mayPlan(PassKind::thread, tool)));
    enable(ActionId::evaluatePath, workbench.path.stored() != nullptr && workbench.workpiece.embedded());
    enable(ActionId::comparePaths, workbench.pathComparer.possible());
    enable(ActionId::drawInterval, workbench.path.selection().has_value());
    enable(ActionId::insertPoint,
           workbench.path.selection() && workbench.path.selection()->source != 0 && workbench.path.evaluated());
    enable(ActionId::stylusEdit, workbench.stylusEditor.active() || (workbench.stylusEditor.possible() && !showing));
    actions_[ActionId::stylusEdit]->setChecked(workbench.stylusEditor.active());
    enable(ActionId::drawEdit, workbench.path.evaluated() && workbench.path.stored() != nullptr &&
                                   lastDrawn(workbench.path.stored()->edits));
    enable(ActionId::post, workbench.program.postable());
    enable(ActionId::breakpoint, !workbench.program.storedText().isEmpty());
    enable(ActionId::findInProgram, !workbench.program.storedText().isEmpty());
    enable(ActionId::overrideCheck, workbench.program.refused() && !workbench.program.busy());
    enable(ActionId::restart, workbench.program.restartable());
    const std::shared_ptr<const CheckedProgram> judged = workbench.program.upToDate();
    enable(ActionId::inspectFaces, judged && !judged->report.deviations.empty()); // a saved verdict has no deviations
    enable(ActionId::playTime, workbench.time.possible() && !showing);
    enable(ActionId::addMarker, workbench.time.possible() && !showing && !workbench.time.showsProgram());
    enable(ActionId::scoreTake, workbench.score.possible());
    const std::int64_t take = showing ? 0 : workbench.mill.chosenTake();
    enable(ActionId::takeUp, workbench.mill.canMove(take, -1));
    enable(ActionId::takeDown, workbench.mill.canMove(take, 1));
    enable(ActionId::duplicateTake, workbench.mill.canCopy(take));
    enable(ActionId::presentTime, workbench.time.away());
    enable(ActionId::punchIn,
           workbench.time.away() && workbench.workpiece.ready() && !showing && !workbench.time.showsProgram());
    updateUndo();
    actions_[ActionId::millMode]->setChecked(workbench.mill.active());
    actions_[ActionId::guides]->setChecked(workbench.guides.on());
    actions_[ActionId::keepFromStock]->setChecked(workbench.mill.stockLayer().on);
    enable(ActionId::recordTrace, !showing && !workbench.mill.recording());
    actions_[ActionId::recordTrace]->setChecked(!workbench.mill.trace().empty());
    actions_[ActionId::clutch]->setChecked(workbench.hand.clutched());
    actions_[ActionId::rateControl]->setChecked(workbench.hand.canRate() &&
                                                workbench.hand.settings().control == WorkspaceControl::rate);
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
