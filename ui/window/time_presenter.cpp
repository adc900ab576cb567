// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/time_presenter.h"

#include "ui/panels/texts.h"
#include "ui/window/take_menu.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace burin {

TimePresenter::TimePresenter(Workbench& workbench, TimelinePanel& panel, ScenePresenter& scene, QObject* parent)
    : Presenter(workbench,
                {&workbench.time, &workbench.session, &workbench.workpiece, &workbench.mill, &workbench.score,
                 &workbench.path, &workbench.growing},
                parent)
    , panel_(panel)
    , scene_(scene) {
    TimeController& time = workbench.time;
    connect(&time, &TimeController::momentChanged, this, &TimePresenter::showMoment);
    connect(&time, &TimeController::recordedChanged, this, &Presenter::presentSoon);
    connect(&workbench.program, &Controller::changed, this, &TimePresenter::followProgram);
    connect(&workbench.workpiece, &WorkpieceController::workpieceChanged, this, &TimePresenter::followProgram);
    connect(&workbench.path, &Controller::changed, this, &TimePresenter::followPath);
    connect(&panel, &TimelinePanel::curveShown, &workbench.deviations, [&workbench](TrackCurve curve, bool shown) {
        if (curve == TrackCurve::deviation) workbench.deviations.setRequested(shown);
    });
    connect(&panel, &TimelinePanel::sought, this, [&time](double seconds) {
        time.pause();
        time.goTo(seconds);
    });
    connect(&panel.view(), &TimelineView::menuRequested, this,
            [this](qint64 take, quint64 sample, const QPoint& position) {
                if (!workbench_.time.showsProgram()) showTakeMenu(workbench_, take, sample, position, &panel_);
            });
    connect(&panel.view(), &TimelineView::takeChosen, this, [this](qint64 take) {
        if (!workbench_.time.showsProgram()) workbench_.mill.chooseTake(take);
    });
    connect(&panel.view(), &TimelineView::markerMenuRequested, this, [this](int marker, const QPoint& position) {
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
    step_ = step;
    followProgram();
    presentSoon();
}

/// While the past is shown, it follows the point that is chosen on the path.
void TimePresenter::followPath() {
    const std::optional<SourceInterval> pointed = workbench_.path.pointed();
    if (std::exchange(pointed_, pointed) == pointed || !pointed || step_ != JobStep::path) return;
    workbench_.time.followPath({pointed->source, pointed->first});
}

void TimePresenter::followProgram() {
    const bool program = step_ == JobStep::program && workbench_.workpiece.milling() && !workbench_.program.edited();
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

std::vector<GrowingClip> TimePresenter::growing() const {
    std::vector<GrowingClip> clips;
    if (workbench_.time.showsProgram()) return clips;
    const std::vector<TakeInfo>& takes = workbench_.mill.allTakes();
    for (const GrowingTake& take : workbench_.growing.takes()) {
        const auto info = std::ranges::find(takes, take.take, &TakeInfo::id);
        const bool underWay = workbench_.growing.underWay(take.take);
        if (info == takes.end() && !underWay) continue; // removed
        clips.push_back({underWay ? tr("Recording") : takeName(info->name), take.seconds, take.strokes});
    }
    return clips;
}

/// The chosen part of the path; empty if nothing is chosen or its take was not read.
std::optional<PointedTime> TimePresenter::pointed() const {
    const std::optional<SourceInterval>& pointed = workbench_.path.pointed();
    if (!pointed || step_ != JobStep::path || workbench_.time.showsProgram()) return std::nullopt;
    if (pointed->source <= 0) return PointedTime{};
    const std::optional<double> first = workbench_.time.secondsAt(Moment{pointed->source, pointed->first}),
                                last = workbench_.time.secondsAt(Moment{pointed->source, pointed->last});
    return first && last ? std::optional(PointedTime{true, *first, *last}) : std::nullopt;
}

void TimePresenter::present() {
    const TimeController& time = workbench_.time;
    TimelinePanelState state;
    state.view.recorded = time.recorded();
    state.view.markers = markers();
    state.view.program = time.showsProgram();
    state.view.growing = growing();
    if (!state.view.growing.empty() && !state.view.recorded) state.view.recorded = std::make_shared<RecordedTime>();
    state.view.pointed = pointed();
    state.view.seconds = time.seconds();
    if (!time.away())
        for (const GrowingClip& clip : state.view.growing) state.view.seconds += clip.seconds;
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
