// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/presenters.h"

#include <initializer_list>

namespace burin {

Presenters::Presenters(Workbench& workbench, const Actions& actions, const Stage& stage, QObject* parent)
    : QObject(parent)
    , millMode(workbench, stage.viewport, this)
    , part(workbench, stage.viewport, *stage.panels.part, this)
    , setups(workbench, stage.viewport, *stage.panels.setup, this)
    , stock(workbench, *stage.panels.stock, *stage.panels.findings, this)
    , zero(workbench, stage.viewport, *stage.panels.zero, this)
    , material(workbench, *stage.panels.material, this)
    , layers(workbench, *stage.panels.layers, this)
    , tool(workbench, *stage.panels.tool, this)
    , allowance(workbench, *stage.panels.allowance, this)
    , mill(workbench, millMode, *stage.panels.mill, this)
    , surroundings(workbench, *stage.panels.surroundings, *stage.panels.bounds, stage.viewport, this)
    , guides(workbench, *stage.panels.guides, this)
    , hand(workbench, *stage.panels.hand, this)
    , pathScene(workbench, stage.viewport, this)
    , path(workbench, *stage.panels.path, pathScene, this)
    , stylusEdit(workbench, *stage.panels.path, pathScene, this)
    , area(workbench, stage.viewport, stage.panels.path->area(), this)
    , program(workbench, *stage.panels.program, this)
    , meters(workbench, *stage.panels.meters, this)
    , status(workbench, meters, millMode, stage.viewport, stage.status, this)
    , job(workbench, stage.stepBar, this)
    , scene(workbench, stage.viewport, actions, this)
    , guideScene(workbench, stage.viewport, actions, this)
    , programScene(workbench, stage.viewport, *stage.panels.program, scene, this)
    , deviation(workbench, stage.viewport, stage.panels.program->deviation(), scene, this)
    , time(workbench, stage.timeline, scene, this)
    , measure(workbench, stage.viewport, this)
    , tree(workbench, stage.tree, scene, this)
    , excess(workbench, stage.viewport, this)
    , faces(workbench, stage.viewport, stage.panels.program->deviation(), this)
    , comparison(workbench, stage.viewport, this)
    , fixtures(workbench, stage.viewport, this)
    , holes(workbench, stage.viewport, this)
    , obstacleMove(workbench, stage.viewport, this)
    , gizmo(workbench, stage.viewport, part, actions, this) {
    connect(&scene, &ScenePresenter::hiddenBodiesChanged, this, [this](const std::set<std::size_t>& bodies) {
        part.setHiddenBodies(bodies);
        setups.setHiddenBodies(bodies);
        zero.setHiddenBodies(bodies);
        measure.setHiddenBodies(bodies);
    });
    connect(&pathScene, &PathScenePresenter::escapeChanged, &status, &Presenter::presentSoon);
    connect(&area, &AreaPresenter::escapeChanged, &status, &Presenter::presentSoon);
    connect(&gizmo, &GizmoPresenter::escapeChanged, &status, &Presenter::presentSoon);
    connect(&fixtures, &FixturePresenter::escapeChanged, &status, &Presenter::presentSoon);
    connect(&obstacleMove, &ObstacleMovePresenter::escapeChanged, &status, &Presenter::presentSoon);
    connect(stage.panels.program, &ProgramPanel::lineChosen, &workbench.time, &TimeController::followLine);
    connect(&time, &TimePresenter::breakpointAsked, this,
            [&workbench, panel = stage.panels.program] { workbench.time.toggleBreakpoint(panel->line()); });
    connect(stage.panels.program, &ProgramPanel::breakpointToggled, &workbench.time, &TimeController::toggleBreakpoint);
    connect(&workbench.time, &TimeController::breakpointsChanged, stage.panels.program,
            [&time = workbench.time, panel = stage.panels.program] { panel->setBreakpoints(time.breakpoints()); });
    connect(&time, &TimePresenter::lineReached, &programScene, &ProgramScenePresenter::followLine);
    connect(&faces, &FacePresenter::marked, &measure, &MeasurePresenter::setOtherMark);
    connect(&path, &PathPresenter::holesRequested, &holes, &HolePresenter::pick);
    connect(&holes, &HolePresenter::picked, &path, &PathPresenter::askAgain);
    connect(&holes, &HolePresenter::marked, &measure, &MeasurePresenter::setOtherMark);
    connect(&programScene, &ProgramScenePresenter::hovered, &deviation, &DeviationPresenter::pointAt);
}

void Presenters::connectActions(const Actions& actions, const Viewport& viewport) {
    setups.connectActions(actions);
    stock.connectActions(actions);
    zero.connectActions(actions);
    surroundings.connectActions(actions);
    guides.connectActions(actions);
    mill.connectActions(actions);
    hand.connectActions(actions, viewport);
    path.connectActions(actions);
    area.connectActions(actions);
    program.connectActions(actions);
    time.connectActions(actions);
    measure.connectActions(actions);
    excess.connectActions(actions);
    faces.connectActions(actions);
    comparison.connectActions(actions);
    fixtures.connectActions(actions);
}

void Presenters::setUnit(LengthUnit unit) {
    for (Presenter* presenter : std::initializer_list<Presenter*>{
             &part,       &setups,   &stock,        &zero,       &material, &layers,      &tool,
             &allowance,  &mill,     &surroundings, &guides,     &hand,     &pathScene,   &path,
             &program,    &meters,   &status,       &job,        &scene,    &guideScene,  &programScene,
             &deviation,  &area,     &time,         &measure,    &tree,     &excess,      &faces,
             &comparison, &fixtures, &holes,        &stylusEdit, &gizmo,    &obstacleMove})
        presenter->setUnit(unit);
}

} // namespace burin
