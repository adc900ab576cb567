// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace_stylus.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// Clocks that count the same ticks differ by rounding alone: a nanosecond apart is the same reading.
constexpr double sameReading = 1e-9; // s

StylusState between(const StylusState& before, const StylusState& after, double time) noexcept {
    const double share = (time - before.time) / (after.time - before.time);
    StylusState state = before; // buttons change when the next reading says so
    state.pose.position = glm::mix(before.pose.position, after.pose.position, share);
    state.pose.rotation = glm::normalize(glm::slerp(before.pose.rotation, after.pose.rotation, share));
    return state;
}

} // namespace

TraceStylus::TraceStylus(std::vector<StylusState> states, StylusDescription description)
    : states_(std::move(states)), description_(std::move(description)) {}

Result<void> TraceStylus::open() {
    if (states_.empty()) return Error{ErrorCode::argumentInvalid, "trace", "0 readings", "at least one reading"};
    ticks_ = std::ranges::any_of(states_, [](const StylusState& state) { return state.period != 0.0; });
    next_ = 0;
    for (std::size_t i = 1; i < states_.size() && !ticks_; ++i)
        if (!(states_[i].time > states_[i - 1].time))
            return Error{ErrorCode::argumentInvalid, "trace", "reading " + std::to_string(i + 1), "times that rise"};
    played_ = false;
    return {};
}

StylusState TraceStylus::nextTick(double time) noexcept {
    StylusState state = states_[std::min(next_, states_.size() - 1)];
    played_ = ++next_ >= states_.size();
    state.time = time;
    return state;
}

StylusState TraceStylus::read(double time) noexcept {
    if (states_.empty() || !std::isfinite(time)) return {};
    if (ticks_) return nextTick(time);
    played_ = time + sameReading >= states_.back().time;
    const auto after = std::upper_bound(states_.begin(), states_.end(), time + sameReading,
                                        [](double t, const StylusState& state) { return t < state.time; });
    StylusState state;
    if (after == states_.begin())
        state = states_.front();
    else if (after == states_.end() || time - std::prev(after)->time <= sameReading)
        state = *std::prev(after);
    else
        state = between(*std::prev(after), *after, time);
    state.time = time;
    return state;
}

} // namespace burin
