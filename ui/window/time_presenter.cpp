// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/time_presenter.h"

#include "ui/panels/texts.h"
#include "ui/window/take_menu.h"

#include <utility>

namespace burin {

TimePresenter::TimePresenter(Workbench& workbench, TimelinePanel& panel, ScenePresenter& scene, QObject* parent)
    : Presenter(workbench,
                {&workbench.time, &workbench.session, &workbench.workpiece, &workbench.mill, &workbench.score}, parent)
    , panel_(panel)
    , scene_(scene) {
    TimeController& time = workbench.time;
    connect(&time, &TimeController::momentChanged, this, &TimePresenter::showMoment);
    connect(&time, &TimeController::recordedChanged, this, &Presenter::presentSoon);
    connect(&workbench.program, &Controller::changed, this, &TimePresenter::followProgram);
    connect(&workbench.workpiece, &WorkpieceController::workpieceChanged, this, &TimePresenter::followProgram);
    connect(&panel, &TimelinePanel::sought, this, [&time](double seconds) {
        time.pause();
        time.goTo(seconds);
    });
    connect(&panel.view(), &TimelineView::menuWanted, this,
            [this](qint64 take, quint64 sample, const QPoint& position) {
                if (!workbench_.time.showsProgram()) showTakeMenu(workbench_, take, sample, position, &panel_);
            });
    connect(&panel.view(), &TimelineView::takeChosen, this, [this](qint64 take) {
        if (!workbench_.time.showsProgram()) workbench_.mill.chooseTake(take);
    });
    connect(&panel.view(), &TimelineView::markerMenuWanted, this, [this](int marker, const QPoint& position) {
        if (!workbench_.time.showsProgram())
            showMarkerMenu(workbench_, static_cast<std::size_t>(marker), position, &panel_);
    });
    connect(&panel, &TimelinePanel::speedChosen, this, [this, &time](double speed) {
        time.setSpeed(speed);
        presentSoon();
    });
}

void TimePresenter::connectActions(const Actions& actions) {
    TimeController& time = workbench_.time;
    connect(actions[ActionId::playTime], &QAction::triggered, this, [&time] {
        if (time.playing())
            time.pause();
        else
            time.play();
    });
    connect(actions[ActionId::addMarker], &QAction::triggered, this, [this] { addMarker(workbench_, &panel_); });
    connect(actions[ActionId::breakpoint], &QAction::triggered, this, &TimePresenter::breakpointAsked);
    connect(actions[ActionId::presentTime], &QAction::triggered, &time, &TimeController::backToPresent);
    connectTakeActions(workbench_, actions);
}

void TimePresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void TimePresenter::setShown(JobStep step) {
    program_ = step == JobStep::program;
    followProgram();
}

void TimePresenter::followProgram() {
    const bool program = program_ && workbench_.workpiece.milling() && !workbench_.program.edited();
    workbench_.time.showProgram(program ? workbench_.program.program() : nullptr);
}

/// For a program, the findings of its check.
std::vector<TimeMarker> TimePresenter::markers() const {
    const TimeController& time = workbench_.time;
    if (!time.showsProgram()) return time.markers();
    std::vector<TimeMarker> markers;
    if (const auto& program = time.programTime())
        for (const ProgramTime::FindingMoment& found : program->findings)
            markers.push_back(
                {found.at, findingText(time.program()->report.findings[found.finding], unit()).toStdString()});
    return markers;
}

void TimePresenter::present() {
    const TimeController& time = workbench_.time;
    TimelinePanelState state;
    state.view.recorded = time.recorded();
    state.view.markers = markers();
    state.view.program = time.showsProgram();
    state.view.seconds = time.seconds();
    state.view.chosen = time.showsProgram() ? 0 : workbench_.mill.chosenTake();
    state.view.away = time.away();
    state.view.enabled = time.possible();
    if (workbench_.score.drawn() && workbench_.score.reference() != 0 && !time.showsProgram()) {
        state.view.scored = workbench_.score.take();
        state.view.reference = workbench_.score.reference();
    }
    state.reading = time.reading();
    state.arriving = time.arriving();
    state.playing = time.playing();
    state.speed = time.speed();
    panel_.setState(state);
}

void TimePresenter::showMoment() {
    scene_.showMoment(workbench_.time.shown());
    if (const int line = workbench_.time.line(); line != std::exchange(line_, line) && line > 0) emit lineReached(line);
    presentSoon();
}

} // namespace burin
