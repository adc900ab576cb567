// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/motion_estimator.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double rounding = 1e-9; // mm

} // namespace

MotionEstimator::MotionEstimator(double step) noexcept : step_(step) {}

void MotionEstimator::add(const glm::dvec3& position, double period) noexcept {
    time_ = count_ == 0 ? 0.0 : time_ + period;
    newest_ = (newest_ + 1) % capacity;
    entries_[newest_] = {position, time_};
    count_ = std::min(count_ + 1, capacity);
    if (count_ < 2) {
        velocity_ = glm::dvec3(0.0);
        return;
    }
    const double share = 1.0 - std::exp(-2.0 * pi * cutoff * period);
    velocity_ += share * ((position - back(1).position) / period - velocity_);
}

bool MotionEstimator::rests() const noexcept {
    for (std::size_t ticks = 1; ticks < count_; ++ticks) {
        const glm::dvec3 off = glm::abs(back(ticks).position - back(0).position);
        if (std::max({off.x, off.y, off.z}) > step_ + rounding) return false;
        if (time_ - back(ticks).time >= restTime - rounding) return true;
    }
    return false;
}

glm::dvec3 MotionEstimator::averaged(double share) const noexcept {
    return count_ < 2 ? back(0).position : glm::mix(back(0).position, back(1).position, share);
}

} // namespace burin
