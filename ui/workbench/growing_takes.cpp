// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/growing_takes.h"

namespace burin {

namespace {

constexpr qint64 leastPause = 100; // ms between reports

} // namespace

GrowingTakes::GrowingTakes(const Desk& desk, const SessionRunner& session, QObject* parent)
    : Controller(desk, parent), session_(session) {
    connect(&session_, &SessionRunner::ticked, this, &GrowingTakes::follow);
}

bool GrowingTakes::underWay(std::int64_t take) const {
    return session_.running() && session_.state().recording && session_.state().take == take;
}

void GrowingTakes::clear() {
    if (takes_.empty()) return;
    takes_.clear();
    cutting_ = due_ = false;
    emit changed();
}

void GrowingTakes::follow() {
    const SessionState& state = session_.state();
    if (state.recording && state.take != 0) {
        if (takes_.empty() || takes_.back().take != state.take) {
            takes_.push_back({state.take, 0.0, {}});
            cutting_ = false;
        }
        GrowingTake& take = takes_.back();
        if (state.cutting && !cutting_) take.strokes.emplace_back(take.seconds, take.seconds);
        take.seconds = state.recordedSeconds;
        if (state.cutting) take.strokes.back().second = take.seconds;
        cutting_ = state.cutting;
        due_ = true;
    }
    if (!due_ || (sinceReport_.isValid() && sinceReport_.elapsed() < leastPause)) return;
    due_ = false;
    sinceReport_.start();
    emit changed();
}

} // namespace burin
