// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/trail_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double period = 0.001;      // s
constexpr double lag = 0.02;          // s: critically damped behind the line's end, so that jumps become a motion
constexpr double shortest = 1e-4;     // mm between two points of a line
constexpr double restDistance = 5e-4; // mm, that may go at once
constexpr double braking = 0.8 * TrailFollower::acceleration; // the rest keeps the law above from being cut off

/// Fastest past a corner for the mean over a time to stay within the tolerance of it: of a sharp one it is off by
/// v T sin(turn / 2) / 4, of one of many on an arc of radius r by (v T)² / (24 r).
double cornerSpeed(const glm::dvec3& in, const glm::dvec3& out, double time) noexcept {
    const double lengths = glm::length(in) * glm::length(out);
    const double half = std::sqrt(std::max(0.0, 0.5 * (1.0 - glm::dot(in, out) / lengths))); // sine of half the turn
    if (half < 1e-6) return std::numeric_limits<double>::infinity();
    const double radius = 0.25 * (glm::length(in) + glm::length(out)) / half;
    constexpr double share = 0.75; // of the tolerance; the rest is for gaining speed behind the corner
    return std::min(4.0 * share * TrailFollower::tolerance / (time * half),
                    std::sqrt(24.0 * share * TrailFollower::tolerance * radius) / time);
}

} // namespace

void TrailFollower::begin(const glm::dvec3& start) noexcept {
    first_ = count_ = oldest_ = 0;
    last_ = passed_ = carrier_ = before_ = mean_ = start;
    recent_.fill(start);
    ahead_ = speed_ = time_ = 0.0;
    velocity_ = glm::dvec3(0.0);
    resting_ = window;
}

bool TrailFollower::append(const glm::dvec3& point) noexcept {
    const double length = glm::distance(last_, point);
    if (length < shortest) return true;
    if (count_ == capacity) return false;
    if (count_ > 0) {
        Corner& bend = corner(count_ - 1);
        const glm::dvec3 from = count_ > 1 ? corner(count_ - 2).point : passed_;
        bend.speed = cornerSpeed(bend.point - from, point - bend.point, period * static_cast<double>(window));
    }
    corner(count_++) = {point, length, 0.0};
    last_ = point;
    ahead_ += length;
    resting_ = 0;
    return true;
}

double TrailFollower::speedLimit() const noexcept {
    double limit = std::numeric_limits<double>::infinity(), way = 0.0;
    const double stopping = speed_ * speed_ / (2.0 * braking) + restDistance + speed_ * period;
    for (std::size_t i = 0; i < count_; ++i) {
        way += i == 0 ? glm::distance(carrier_, corner(0).point) : corner(i).length;
        limit = std::min(limit, std::sqrt(corner(i).speed * corner(i).speed + 2.0 * braking * way));
        if (way > stopping) break;
    }
    return limit;
}

void TrailFollower::advance(double way) noexcept {
    ahead_ = std::max(0.0, ahead_ - way);
    while (count_ > 0) {
        const glm::dvec3 rest = corner(0).point - carrier_;
        const double length = glm::length(rest);
        if (way < length) {
            carrier_ += rest * (way / length);
            return;
        }
        way -= length;
        carrier_ = passed_ = corner(0).point;
        first_ = (first_ + 1) % capacity;
        --count_;
    }
    ahead_ = 0.0;
}

void TrailFollower::tick(double maximumSpeed) noexcept {
    if (count_ > 0) {
        const double pull = ahead_ / (lag * lag) - 2.0 * speed_ / lag;
        const double change = acceleration * period;
        double speed = speed_ + std::clamp(pull * period, -change, change);
        speed = std::max(std::min({speed, maximumSpeed, speedLimit()}), speed_ - change);
        speed_ = std::clamp(speed, 0.0, ahead_ / period);
        advance(speed_ * period);
        if (ahead_ <= restDistance) { // there
            carrier_ = passed_ = last_;
            count_ = 0;
            ahead_ = 0.0;
        }
        if (count_ == 0) speed_ = 0.0;
    }
    resting_ = count_ == 0 ? std::min(resting_ + 1, window) : 0;
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
    return glm::mix(before_, mean_, time_ / period); // a tick late, and even at any rate
}

bool TrailFollower::finished() const noexcept {
    return count_ == 0 && resting_ == window && before_ == mean_;
}

} // namespace burin
