// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/mill_presenter.h"

#include "core/job/feed_proposal.h"
#include "core/verify/load_limits.h"
#include "ui/panels/texts.h"
#include "ui/window/session_labels.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr int hintStays = 1200; // ms: short-lived flags must not change the panel's layout

QString feedBoundText(FeedBound bound) {
    switch (bound) {
    case FeedBound::chip:
        break;
    case FeedBound::plunge:
        return MeterPresenter::tr("Plunge feed, because the tool plunges");
    case FeedBound::thinned:
        return MeterPresenter::tr("Thin chip: limited to twice the feed of the cutting data");
    case FeedBound::load:
        return MeterPresenter::tr("Limited by the strength of the tool or the power of the spindle");
    case FeedBound::limit:
        return MeterPresenter::tr("Limited by the maximum chip load of the tool or the maximum feed of the machine");
    }
    return MeterPresenter::tr("Limited by the chip load of the cutting data");
}

} // namespace

MillPresenter::MillPresenter(Workbench& workbench, MillMode& mode, MillPanel& panel, QObject* parent)
    : Presenter(workbench,
                {&workbench.mill, &workbench.workpiece, &workbench.session, &workbench.showMe, &workbench.setup,
                 &workbench.styluses},
                parent)
    , mode_(mode)
    , panel_(panel) {
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&mode, &MillMode::settingsChanged, this, &Presenter::presentSoon);
    connect(&panel, &MillPanel::millModeToggled, this, [this](bool on) {
        if (workbench_.showMe.showing())
            workbench_.showMe.stop();
        else if (on)
            workbench_.mill.enter();
        else
            workbench_.mill.leave();
    });
    connect(&mode, &MillMode::toolChanged, this, &Presenter::presentSoon);
    connect(&panel, &MillPanel::rasterChosen, this, &MillPresenter::setRaster);
    connect(&panel, &MillPanel::stepOverEdited, this, [this](double value) {
        edit([](MillToolSettings& settings, double wanted) { settings.stepOver = wanted; }, value);
    });
    connect(&panel, &MillPanel::repeatRequested, this, [this](RepeatChoice how) {
        mode_.repeat(how == RepeatChoice::lower  ? MillTool::Repetition::lower
                     : how == RepeatChoice::left ? MillTool::Repetition::left
                                                 : MillTool::Repetition::right);
    });
    connect(&panel, &MillPanel::stylusChosen, this,
            [this](int index) { workbench_.styluses.choose(static_cast<std::size_t>(index)); });
    connect(&panel, &MillPanel::undoStrokeRequested, &workbench, &Workbench::undoLast);
    connect(&panel, &MillPanel::redoStrokeRequested, &workbench, &Workbench::redoLast);
    connect(&panel, &MillPanel::depthRuleChosen, this, [this](DepthChoice choice) {
        MillToolSettings settings = mode_.settings();
        settings.rule = choice == DepthChoice::part ? DepthRule::part : DepthRule::level;
        mode_.setSettings(settings);
    });
    connect(&panel, &MillPanel::depthOfCutEdited, this, [this](double value) {
        edit([](MillToolSettings& settings, double wanted) { settings.depthOfCut = wanted; }, value);
    });
    connect(&panel, &MillPanel::pressEdited, this, [this](double value) {
        edit([](MillToolSettings& settings, double wanted) { settings.press = wanted; }, value);
    });
    connect(&panel, &MillPanel::speedEdited, this, [this](double value) {
        edit([](MillToolSettings& settings, double wanted) { settings.speed = wanted; }, value);
    });
    connect(&panel, &MillPanel::penRuleChosen, this, [this](PenChoice choice) {
        MillToolSettings settings = mode_.settings();
        settings.pen = choice == PenChoice::sink ? PenRule::sink : PenRule::depth;
        mode_.setSettings(settings);
    });
    connect(&panel, &MillPanel::sinkSpeedEdited, this, [this](double value) {
        edit([](MillToolSettings& settings, double wanted) { settings.sinkSpeed = wanted; }, value);
    });
    connect(&panel, &MillPanel::showMeRequested, this, [this] {
        if (workbench_.showMe.showing())
            workbench_.showMe.stop();
        else
            workbench_.showHowItIsDone();
    });
    connect(&panel, &MillPanel::takeRemovalRequested, this, &MillPresenter::takeRemovalRequested);
}

void MillPresenter::edit(void (*change)(MillToolSettings&, double), double value) {
    MillToolSettings settings = mode_.settings();
    change(settings, value);
    mode_.setSettings(settings);
}

void MillPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void MillPresenter::connectActions(const Actions& actions) {
    actions_ = &actions;
    connect(actions[ActionId::raster], &QAction::triggered, this, &MillPresenter::setRaster);
    const std::pair<ActionId, MillTool::Repetition> repetitions[] = {
        {ActionId::repeatLower, MillTool::Repetition::lower},
        {ActionId::repeatLeft, MillTool::Repetition::left},
        {ActionId::repeatRight, MillTool::Repetition::right}};
    for (const auto& [id, how] : repetitions)
        connect(actions[id], &QAction::triggered, this, [this, repetition = how] { mode_.repeat(repetition); });
    connect(actions[ActionId::showMe], &QAction::triggered, this, [this] { workbench_.showHowItIsDone(); });
    connect(actions[ActionId::stopShow], &QAction::triggered, this, [this] { workbench_.showMe.stop(); });
    presentSoon();
}

void MillPresenter::setRaster(bool on) {
    MillToolSettings settings = mode_.settings();
    settings.drag = on ? DragRule::raster : DragRule::stroke;
    mode_.setSettings(settings);
}

QString MillPresenter::lockText() const {
    switch (mode_.lock()) {
    case StrokeLock::none:
        break;
    case StrokeLock::alongX:
        return tr("Strokes are locked to X. Press X to unlock.");
    case StrokeLock::alongY:
        return tr("Strokes are locked to Y. Press Y to unlock.");
    case StrokeLock::direction:
        return tr("Strokes are locked to their direction. Press D to unlock.");
    }
    return {};
}

QString MillPresenter::missing() const {
    const WorkpieceController& workpiece = workbench_.workpiece;
    if (workbench_.showMe.showing()) return tr("The virtual operator is milling; stop it to mill yourself.");
    if (!workbench_.setup.hasPart()) return tr("Import a part first.");
    if (workpiece.embedding()) return tr("The part is being embedded.");
    if (!workpiece.embedded()) return tr("Embed the part in its stock first.");
    if (workpiece.lacksBounds())
        return tr("There is no boundary for the tool: choose another tool, or embed again, with larger voxels where "
                  "memory was short.");
    if (!workpiece.bounds()) return tr("The boundary for the tool is being computed.");
    return {};
}

QString MillPresenter::hint() {
    const MillController& mill = workbench_.mill;
    const auto& bounds = workbench_.workpiece.bounds();
    if (!mill.active() || !bounds) return hint_ = {};
    const StylusDescription* stylus = mill.device() ? &mill.device()->description : nullptr;
    QString now = hintSentence(workbench_.session.state(), *bounds, stylus, workbench_.hand.settings().forceButton);
    if (now.isEmpty() && mode_.penLeans() && !bounds->axis().free)
        now = tr("The tool axis is fixed, so the pen's tilt has no effect. Choose the axis “free, with the hand” in "
                 "the step Stock to lean the tool.");
    if (now.isEmpty() && !hint_.isEmpty() && hintSince_.elapsed() < hintStays) return hint_;
    if (!now.isEmpty()) hintSince_.start();
    return hint_ = now;
}

void MillPresenter::present() {
    const MillController& mill = workbench_.mill;
    const SessionState& session = workbench_.session.state();
    MillState state;
    state.missing = missing();
    state.ready = workbench_.workpiece.ready() && !workbench_.showMe.showing();
    state.active = mill.active();
    state.recording = workbench_.session.running() && session.recording;
    state.recordedSeconds = session.recordedSeconds;
    state.cutting = workbench_.session.running() && session.cutting && !workbench_.showMe.showing();
    StrokeHistory& strokes = workbench_.workpiece.strokes();
    state.canUndoStroke = strokes.canUndo() && !workbench_.showMe.showing();
    state.undoableStrokes = strokes.count();
    state.canRedoStroke = strokes.canRedo() && !workbench_.showMe.showing();
    const MillToolSettings& settings = mode_.settings();
    state.depthRule = settings.rule == DepthRule::part ? DepthChoice::part : DepthChoice::level;
    state.depthOfCut = settings.depthOfCut;
    state.press = settings.press;
    state.speed = settings.speed;
    state.pen = mode_.hasPen();
    state.penRule = settings.pen == PenRule::sink ? PenChoice::sink : PenChoice::depth;
    state.sinkSpeed = settings.sinkSpeed;
    state.raster = settings.drag == DragRule::raster;
    state.stepOver = settings.stepOver;
    state.canRepeat = mode_.canRepeat();
    state.lock = lockText();
    if (actions_ != nullptr) {
        (*actions_)[ActionId::raster]->setChecked(state.raster);
        for (const ActionId id : {ActionId::repeatLower, ActionId::repeatLeft, ActionId::repeatRight})
            (*actions_)[id]->setEnabled(state.canRepeat);
    }
    if (workbench_.session.running() && workbench_.workpiece.milling())
        state.alarm = alarmSentence(session, *workbench_.workpiece.milling());
    state.hint = hint();
    for (const TakeInfo& take : mill.takes()) {
        TakeRow row{take, toolName(workbench_.tool.tools(), take.toolId), workbench_.mill.strokesOf(take.id), false};
        row.replaying = workbench_.workpiece.embedding();
        row.recording = state.recording && take.id == session.take;
        if (row.recording) row.info.seconds = session.recordedSeconds;
        state.takes.push_back(std::move(row));
    }
    state.showing = workbench_.showMe.showing();
    for (const StylusController::Choice& choice : workbench_.styluses.choices())
        state.styluses << (choice.there ? choice.name : tr("%1 (not plugged in)").arg(choice.name));
    state.stylus = static_cast<int>(workbench_.styluses.chosen());
    panel_.setState(state);
}

MeterPresenter::MeterPresenter(Workbench& workbench, Meters& meters, QObject* parent)
    : Presenter(workbench, {&workbench.session}, parent), meters_(meters) {
    connect(&workbench.session, &SessionRunner::ticked, this, &MeterPresenter::tick);
}

void MeterPresenter::setUnit(LengthUnit unit) {
    meters_.setUnit(unit);
    Presenter::setUnit(unit);
}

void MeterPresenter::tick() {
    const SessionState& session = workbench_.session.state();
    state_.rateHz = session.rateHz;
    state_.workP999 = session.cpuP999;
    state_.intervalP999 = session.intervalP999;
    state_.missed = session.missed;
    state_.late = session.late;
    state_.scheduling = session.scheduling;
    state_.force = glm::length(session.sample.cuttingForce);
    state_.forceScale = std::max(state_.forceScale, state_.force);
    takeForceLimit();
    takeProposedFeed();
    state_.removalRate = session.removalRate;
    state_.removalScale = std::max(state_.removalScale, state_.removalRate);
    if (workbench_.workpiece.milling())
        state_.tip = session.sample.proxy.tip - workbench_.workpiece.milling()->setup.workOffset;
    presentSoon();
}

/// For the tool in use, at the spindle speed of its tables.
void MeterPresenter::takeForceLimit() {
    const auto milling = workbench_.workpiece.milling();
    if (!milling || !(milling->conditions.spindleSpeed > 0.0)) return;
    const ForceLimit limit = forceLimit(milling->tool, milling->machine, milling->conditions.spindleSpeed);
    state_.forceLimit = limit.force;
    state_.forceLimitOf = limit.kind == FindingKind::spindlePower    ? tr("the spindle's power")
                          : limit.kind == FindingKind::spindleTorque ? tr("the spindle's torque")
                                                                     : tr("the tool may break");
}

/// Keeps the value of the last cut, so that it can be read after a stroke.
void MeterPresenter::takeProposedFeed() {
    const auto milling = workbench_.workpiece.milling();
    const SmoothedCut& cut = workbench_.session.state().cut;
    if (!milling || !cut.cuts()) return;
    const PropertyList& materials = milling->embedded.workpiece.properties();
    const auto proposal = proposeFeed(cut, milling->tool, milling->machine, materials);
    state_.proposed.reset();
    if (!proposal) return;
    state_.proposed = ProposedFeed{proposal->feed,
                                   proposal->spindleSpeed,
                                   cut.arc,
                                   cut.depth,
                                   materialName(materials[proposal->material]),
                                   feedBoundText(proposal->bound)};
}

void MeterPresenter::present() {
    const bool running = workbench_.session.running();
    if (running != state_.running) {
        state_ = {};
        state_.running = running;
    }
    if (running)
        state_.stylus = workbench_.showMe.showing() ? tr("Virtual operator %1 ×").arg(ShowMe::timeLapse)
                                                    : workbench_.styluses.chosenName();
    meters_.setState(state_);
    emit presented();
}

} // namespace burin
