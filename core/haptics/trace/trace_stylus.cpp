// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/trace_stylus.h"

#include <cmath>
#include <string>
#include <utility>

namespace burin {

namespace {

/// Clocks that count the same ticks differ only by rounding errors: times within a nanosecond mean the same reading.
constexpr double sameReading = 1e-9; // s

StylusState between(const StylusState& before, const StylusState& after, double time) noexcept {
    const double share = (time - before.time) / (after.time - before.time);
    StylusState state = before; // buttons change only with the next reading
    state.pose.position = glm::mix(before.pose.position, after.pose.position, share);
    state.pose.rotation = glm::normalize(glm::slerp(before.pose.rotation, after.pose.rotation, share));
    return state;
}

} // namespace

TraceStylus::TraceStylus(std::vector<StylusState> states, StylusDescription description)
    : TraceStylus(playbackOf(std::move(states)), std::move(description)) {}

TraceStylus::TraceStylus(std::unique_ptr<TracePlayback> readings, StylusDescription description)
    : readings_(std::move(readings)), description_(std::move(description)) {}

Result<void> TraceStylus::open() {
    const TraceExtent& extent = readings_->extent();
    if (extent.readings == 0) return Error{ErrorCode::argumentInvalid, "trace", "0 readings", "at least one reading"};
    if (!extent.ticks && extent.firstOutOfOrder != 0)
        return Error{ErrorCode::argumentInvalid, "trace", "reading " + std::to_string(extent.firstOutOfOrder),
                     "times that rise"};
    if (Result<void> begun = readings_->rewind(); !begun) return begun;
    reached_ = played_ = false;
    more_ = readings_->next(after_);
    return {};
}

void TraceStylus::advance() noexcept {
    before_ = after_;
    reached_ = true;
    more_ = readings_->next(after_);
}

StylusState TraceStylus::nextTick(double time) noexcept {
    if (more_) advance();
    played_ = !more_;
    StylusState state = before_;
    state.time = time;
    return state;
}

StylusState TraceStylus::at(double time) noexcept {
    while (more_ && after_.time <= time + sameReading) advance();
    played_ = !more_;
    StylusState state;
    if (!reached_)
        state = after_;
    else if (!more_ || time - before_.time <= sameReading)
        state = before_;
    else
        state = between(before_, after_, time);
    state.time = time;
    return state;
}

StylusState TraceStylus::read(double time) noexcept {
    if ((!reached_ && !more_) || !std::isfinite(time)) return {};
    return readings_->extent().ticks ? nextTick(time) : at(time);
}

} // namespace burin
