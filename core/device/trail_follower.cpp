// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/trail_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double period = 0.001; // s
constexpr double lag = 0.02; // s: critically damped approach to the line's end, so that jumps become a smooth motion
constexpr double restDistance = 5e-4; // mm; a remaining distance up to this is covered at once
// the remaining share keeps the control law above from being cut off
constexpr double braking = 0.8 * TrailFollower::acceleration;

static_assert(PointerTrail::meanTime == 16 * period);

} // namespace

void TrailFollower::begin(const glm::dvec3& start, const glm::dvec3& axis) noexcept {
    trail_.begin(start, axis);
    oldest_ = 0;
    carrier_ = before_ = mean_ = start;
    recent_.fill(start);
    speed_ = time_ = 0.0;
    velocity_ = glm::dvec3(0.0);
    resting_ = window;
}

bool TrailFollower::append(const glm::dvec3& goal, double grain, const glm::dvec3& axis) noexcept {
    const std::size_t before = trail_.ahead();
    if (!trail_.append(goal, grain, axis)) return false;
    if (trail_.ahead() > before) resting_ = 0;
    return true;
}

/// Distance to the line's end, mm.
double TrailFollower::aheadLength() const noexcept {
    return trail_.ahead() == 0 ? 0.0 : glm::distance(carrier_, trail_.point(0).place) + trail_.lengthBeyond();
}

double TrailFollower::speedLimit() const noexcept {
    double limit = std::numeric_limits<double>::infinity(), way = 0.0;
    const double stopping = speed_ * speed_ / (2.0 * braking) + restDistance + speed_ * period;
    for (std::size_t i = 0; i < trail_.ahead(); ++i) {
        const PointerTrail::Point& point = trail_.point(i);
        way += i == 0 ? glm::distance(carrier_, point.place) : point.length;
        limit = std::min(limit, std::sqrt(point.speed * point.speed + 2.0 * braking * way));
        if (way > stopping) break;
    }
    return limit;
}

void TrailFollower::advance(double way) noexcept {
    while (trail_.ahead() > 0) {
        const glm::dvec3& next = trail_.point(0).place;
        const glm::dvec3 rest = next - carrier_;
        const double length = glm::length(rest);
        if (way < length) {
            carrier_ += rest * (way / length);
            return;
        }
        way -= length;
        carrier_ = next;
        trail_.pass();
    }
}

void TrailFollower::tick(double maximumSpeed) noexcept {
    if (const double ahead = aheadLength(); trail_.ahead() > 0) {
        const double pull = ahead / (lag * lag) - 2.0 * speed_ / lag;
        const double change = acceleration * period;
        double speed = speed_ + std::clamp(pull * period, -change, change);
        speed = std::max(std::min({speed, maximumSpeed, speedLimit()}), speed_ - change);
        speed_ = std::clamp(speed, 0.0, ahead / period);
        advance(speed_ * period);
        if (aheadLength() <= restDistance) { // arrived
            carrier_ = trail_.end();
            trail_.passAll();
        }
        if (trail_.ahead() == 0) speed_ = 0.0;
    }
    resting_ = trail_.ahead() == 0 ? std::min(resting_ + 1, window) : 0;
    recent_[oldest_] = carrier_;
    oldest_ = (oldest_ + 1) % window;
    before_ = mean_;
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& place : recent_) sum += place;
    mean_ = resting_ == window ? carrier_ : sum / static_cast<double>(window);
    velocity_ = (mean_ - before_) / period;
}

glm::dvec3 TrailFollower::step(double seconds, double maximumSpeed) noexcept {
    for (time_ += seconds; time_ >= period; time_ -= period) tick(maximumSpeed);
    return glm::mix(before_, mean_, time_ / period); // one tick late, and evenly for any rate of calls
}

bool TrailFollower::finished() const noexcept {
    return trail_.ahead() == 0 && resting_ == window && before_ == mean_;
}

} // namespace burin
