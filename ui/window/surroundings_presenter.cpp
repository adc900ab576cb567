// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/surroundings_presenter.h"

namespace burin {

namespace {

BoundNews newsOf(const std::optional<LayerNews>& news) {
    if (!news) return BoundNews::none;
    if (news->state == BoundaryLayers::State::waiting) return BoundNews::waits;
    return news->holds ? BoundNews::holds : BoundNews::none;
}

} // namespace

SurroundingsPresenter::SurroundingsPresenter(Workbench& workbench, SurroundingsPanel& panel, BoundsPanel& switches,
                                             Viewport& viewport, QObject* parent)
    : Presenter(workbench,
                {&workbench.surroundings, &workbench.setup, &workbench.stockSolid, &workbench.workpiece,
                 &workbench.mill, &workbench.fixtures, &workbench.mover},
                parent)
    , panel_(panel)
    , switches_(switches)
    , viewport_(viewport) {
    SurroundingsController& surroundings = workbench.surroundings;
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&panel, &SurroundingsPanel::additionRequested, this, &SurroundingsPresenter::add);
    connect(&panel, &SurroundingsPanel::obstacleEdited, &surroundings, &SurroundingsController::change);
    connect(&panel, &SurroundingsPanel::obstacleSwitched, &surroundings, &SurroundingsController::setOn);
    connect(&panel, &SurroundingsPanel::obstacleRemovalRequested, &surroundings, &SurroundingsController::remove);
    connect(&panel, &SurroundingsPanel::obstacleChangeRequested, this, &SurroundingsPresenter::change);
    connect(&panel, &SurroundingsPanel::travelSwitched, &surroundings, &SurroundingsController::setTravelOn);
    connect(&panel, &SurroundingsPanel::axisChosen, &surroundings, &SurroundingsController::setAxis);
    connect(&switches, &BoundsPanel::obstacleSwitched, &surroundings, &SurroundingsController::setOn);
    connect(&switches, &BoundsPanel::travelSwitched, &surroundings, &SurroundingsController::setTravelOn);
}

void SurroundingsPresenter::connectActions(const Actions& actions) {
    const QAction* axisOfView = actions[ActionId::axisOfView];
    connect(axisOfView, &QAction::triggered, this, [this] {
        workbench_.surroundings.setAxis({false, -viewport_.sight(QRectF(viewport_.rect()).center()).rayDirection});
    });
    connect(&panel_, &SurroundingsPanel::axisOfViewRequested, axisOfView, &QAction::trigger);
}

void SurroundingsPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void SurroundingsPresenter::add(SurroundingsPanel::Addition addition) {
    using enum SurroundingsPanel::Addition;
    SurroundingsController& surroundings = workbench_.surroundings;
    switch (addition) {
    case fixtureBox:
        return surroundings.addBox(ObstacleKind::fixture);
    case fixtureCylinder:
        return surroundings.addCylinder(ObstacleKind::fixture);
    case keepOutBox:
        return surroundings.addBox(ObstacleKind::keepOut);
    case keepOutCylinder:
        return surroundings.addCylinder(ObstacleKind::keepOut);
    case fixtureFile:
        return emit fixtureFileRequested();
    case fixtureOfLibrary:
        emit libraryFixtureRequested();
    }
}

/// A fixture of the library has a dialog; any other is moved in the view, until this is requested again.
void SurroundingsPresenter::change(std::size_t place) {
    if (place >= workbench_.surroundings.obstacles().size()) return;
    if (workbench_.surroundings.obstacles()[place].obstacle->design)
        workbench_.fixtures.beginChange(place);
    else if (workbench_.mover.place() == place)
        workbench_.mover.accept();
    else
        workbench_.mover.begin(place);
}

void SurroundingsPresenter::present() {
    const SurroundingsController& surroundings = workbench_.surroundings;
    const ObstacleMover& mover = workbench_.mover;
    SurroundingsState state;
    state.hasPart = workbench_.setup.hasPart();
    std::vector<ObstacleMark> marks;
    for (std::size_t i = 0; i < surroundings.obstacles().size(); ++i) {
        const PlacedObstacle& placed = surroundings.obstacles()[i];
        const BoundNews news = newsOf(surroundings.news(i));
        const std::optional<FixtureFit> fit =
            state.hasPart ? workbench_.stockSolid.fitOf(placed.obstacle) : std::optional(FixtureFit{});
        const bool moving = i == mover.place();
        state.obstacles.push_back({placed.obstacle, placed.on, news, fit.value_or(FixtureFit{}), moving});
        // The numbers of a mesh follow when its move ends.
        if (moving && !std::holds_alternative<TriangleMesh>(placed.obstacle->shape))
            state.obstacles.back().obstacle = std::make_shared<const Obstacle>(mover.moved());
        if (i != workbench_.fixtures.instead() || !workbench_.fixtures.preview())
            marks.push_back(
                {placed.obstacle, placed.on, news == BoundNews::holds, moving ? mover.motion() : Placement{}});
    }
    if (const std::shared_ptr<const Obstacle>& fixture = workbench_.fixtures.preview())
        marks.push_back({fixture, true, workbench_.fixtures.problem().has_value()});
    if (workbench_.workpiece.embedded()) { // bodies of the model with the role of fixtures
        const std::shared_ptr<const MillingContext> milling = workbench_.workpiece.milling();
        for (const Obstacle& fixture : milling->bodyFixtures)
            marks.push_back({std::shared_ptr<const Obstacle>(milling, &fixture), true, false});
    }
    state.travelOn = surroundings.travelOn();
    state.travel = newsOf(surroundings.travelNews());
    state.axis = surroundings.axis();
    state.locked = surroundings.locked();
    state.busy = surroundings.importing();
    state.zero = workbench_.setup.setup().workOffset;
    panel_.setState(state);
    switches_.setState(state);
    viewport_.setObstacles(marks);
}

} // namespace burin
