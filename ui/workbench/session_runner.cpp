// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/session_runner.h"

#include <chrono>

namespace burin {

SessionRunner::SessionRunner(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    frame_.setTimerType(Qt::PreciseTimer);
    frame_.setInterval(std::chrono::milliseconds(16));
    connect(&frame_, &QTimer::timeout, this, &SessionRunner::look);
    healthTimer_.setInterval(std::chrono::milliseconds(300));
    connect(&healthTimer_, &QTimer::timeout, this, &SessionRunner::readHealth);
}

SessionRunner::~SessionRunner() = default;

void SessionRunner::begin(const Place& place, AnyStylus stylus, const SessionRequest& request, Then then) {
    // std::function requires a copyable object
    auto held = std::make_shared<AnyStylus>(std::move(stylus));
    desk_.project.lend([this, place, held, request, then = std::move(then)](Project* project) {
        if (session_ || !project) { // another session was started first
            then(false);
            return;
        }
        view_ = {place.milling->embedded.workpiece.snapshot(), std::nullopt};
        Result<std::unique_ptr<MillingSession>> session =
            MillingSession::begin(*project, *place.milling, *place.bounds, *held, *place.strokes, request);
        if (!session) {
            emit failed(session.error());
            then(false);
            return;
        }
        place_ = place;
        stylus_ = std::make_unique<AnyStylus>(std::move(*held));
        session_ = std::move(*session);
        state_ = {};
        ended_ = false;
        frame_.start();
        healthTimer_.start();
        then(true);
        if (!request.takeName.empty()) emit recordingStarted();
        emit changed();
    });
}

void SessionRunner::end(Then then) {
    desk_.project.lend([this, then = std::move(then)](Project*) {
        if (session_) {
            frame_.stop();
            healthTimer_.stop();
            health_ = {};
            const Result<LoopStatistics> outcome = session_->end();
            session_.reset();
            // Kept until the users of the stylus have released it below.
            const std::unique_ptr<AnyStylus> stylus = std::move(stylus_);
            const Place place = std::exchange(place_, {});
            state_.recording = false;
            view_ = {};
            if (!outcome) emit failed(outcome.error());
            emit ended();
            emit changed();
        }
        if (then) then(true);
    });
}

void SessionRunner::withSession(std::function<Result<void>(MillingSession&)> use, Then then) {
    desk_.project.lend([this, use = std::move(use), then = std::move(then)](Project*) {
        if (!session_) {
            if (then) then(false);
            return;
        }
        const Result<void> outcome = use(*session_);
        if (!outcome) emit failed(outcome.error());
        look();
        if (then) then(outcome.hasValue());
        emit changed();
    });
}

void SessionRunner::startRecording(const QString& name, Then then) {
    withSession([name = name.toStdString()](MillingSession& session) { return session.startRecording(name); },
                [this, then = std::move(then)](bool started) {
                    if (started) emit recordingStarted();
                    if (then) then(started);
                });
}

void SessionRunner::stopRecording(Then then) {
    withSession([](MillingSession& session) { return session.stopRecording(); }, std::move(then));
}

void SessionRunner::undoStroke(Then then) {
    withSession([](MillingSession& session) { return session.undoStroke(); }, std::move(then));
}

void SessionRunner::redoStroke(Then then) {
    withSession([](MillingSession& session) { return session.redoStroke(); }, std::move(then));
}

void SessionRunner::setAllowance(double millimetres) {
    if (session_) session_->setAllowance(millimetres);
}

void SessionRunner::setLayer(std::size_t layer, bool on) {
    if (!session_) return;
    if (const Result<void> set = session_->setLayer(layer, on); !set) emit failed(set.error());
}

void SessionRunner::setStockLayer(bool on) {
    if (!session_) return;
    if (const Result<void> set = session_->setStockLayer(on); !set) emit failed(set.error());
}

Result<void> SessionRunner::setGuides(const GuideSettings& guides) {
    return session_ ? session_->setGuides(guides) : Result<void>{};
}

void SessionRunner::stepGuides(int levels) {
    if (session_) session_->stepGuides(levels);
}

void SessionRunner::setWorkspace(const WorkspaceSettings& workspace) {
    if (session_) session_->setWorkspace(workspace);
}

void SessionRunner::readHealth() {
    if (!session_) return;
    health_ = session_->health();
    emit healthRead();
}

void SessionRunner::look() {
    if (!session_) return;
    if (session_->newest(state_)) emit ticked();
    trace_.clear();
    session_->takeTrace(trace_);
    if (!trace_.empty()) emit traced(trace_);
    if (session_->newestView(view_)) emit viewed(view_);
    if (const std::optional<Error> fault = session_->takeFault()) emit failed(*fault);
    if (!session_->ended() || ended_) return;
    ended_ = true;
    emit endedByItself();
}

} // namespace burin
