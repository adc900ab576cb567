// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/session_settings.h"

#include "core/job/session_faults.h"

namespace burin {

namespace {

/// Returns the period of a tick, s.
double periodOf(const StylusHandle& stylus, const SessionRequest& request) {
    const double rate = stylus.device().description().rate.value;
    if (stylus.selfPaced() != nullptr && rate > 0.0) return 1.0 / rate; // only the stylus can pace the loop
    return request.period > 0.0 ? request.period : ServoSettings{}.period;
}

} // namespace

HapticSettings hapticSettings(const MillingContext& milling, const AxisMode& axis, const StylusHandle& stylus,
                              const SessionRequest& request) {
    HapticSettings settings;
    settings.axis = axis;
    settings.mapping = request.mapping;
    settings.stylus = stylus.device().description();
    settings.tickPeriod = periodOf(stylus, request);
    settings.allowance = request.allowance;
    settings.cuttingSpeed = milling.conditions.surfaceSpeed;
    settings.cutsOnButton = request.cutsOnButton;
    settings.forceButtons = request.forceButtons;
    settings.felt = request.felt;
    settings.stock = request.stock;
    settings.gains = request.gains;
    return settings;
}

ServoSettings servoSettings(const StylusHandle& stylus, const SessionRequest& request) {
    ServoSettings settings;
    settings.period = periodOf(stylus, request);
    settings.pace = request.pace;
    settings.maximumSeconds = request.maximumSeconds;
    settings.ticksPerEdge = request.ticksPerEdge;
    return settings;
}

std::filesystem::path flightFolder(const Project& project, const SessionRequest& request) {
    if (request.pace != Pace::realtime || request.ticksPerEdge > 1) return {};
    return request.flights.empty() ? SessionFaults::folderBeside(project.file()) : request.flights;
}

LayerNews layerNews(const LayersNews& news, std::size_t layer) {
    return {news.state(layer), news.holds(layer), news.ticksHeld[layer]};
}

SessionState sessionState(const TickNews& news, const LiveFigures& figures, std::size_t layerCount, double unitVolume) {
    SessionState state;
    state.sample = news.sample;
    state.wallTime = std::chrono::steady_clock::time_point(std::chrono::nanoseconds(news.timing.over));
    state.recording = news.take != 0;
    state.take = news.take;
    state.recordedSeconds = state.recording ? news.sample.time : 0.0;
    state.cutting = news.cutting;
    state.rateHz = figures.rateHz;
    state.cpuP999 = figures.cpuP999;
    state.workP999 = figures.workP999;
    state.intervalP999 = figures.intervalP999;
    state.late = figures.late;
    state.ticks = news.ticks;
    state.missed = news.timing.missed;
    state.scheduling = news.timing.scheduling;
    state.removalRate = news.removalRate * unitVolume;
    state.cut = news.cut;
    state.heaviestCut = news.heaviestCut;
    state.shankPiece = news.shank.piece;
    state.shankTouches = news.shank.property;
    state.guides = news.guides;
    for (std::size_t i = 0; i < layerCount; ++i) state.layers.push_back(layerNews(news.layers, i));
    state.workspaceScale = news.workspaceScale;
    state.clutched = news.clutched;
    return state;
}

} // namespace burin
