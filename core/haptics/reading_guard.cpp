// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/reading_guard.h"

#include <algorithm>

namespace burin {
namespace {

bool plausible(const Pose& pose) noexcept {
    constexpr double farthest = 10'000.0; // mm; no device reaches that far from its zero
    const glm::dquat& q = pose.rotation;
    return glm::length(pose.position) <= farthest && std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) &&
           std::isfinite(q.z);
}

} // namespace

Reading ReadingGuard::check(const StylusState& state, double period) noexcept {
    if (!state.valid || !plausible(state.pose)) {
        known_ = false;
        return Reading::fault;
    }
    const glm::dvec3 moved = known_ ? state.pose.position - last_.position : glm::dvec3(0.0);
    last_ = state.pose;
    known_ = true;
    if (!std::isfinite(period) || period <= 0.0 || period > gaps_.stalled) return Reading::fault;
    const double distance = glm::length(moved);
    // An early tick must not make a calm hand look fast.
    if (!(distance <= largestJump) || distance > maximumSpeed_ * std::max(period, nominalPeriod_))
        return Reading::fault;
    return period > gaps_.late ? Reading::late : Reading::good;
}

} // namespace burin
