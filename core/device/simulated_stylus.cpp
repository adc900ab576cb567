// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/simulated_stylus.h"

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/geometry/angle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double brakingShare = 0.8;    // of the acceleration: the remaining share prevents overshooting a moving goal
constexpr double longestStep = 0.001;   // s
constexpr double longestGap = 0.010;    // s
constexpr double restDistance = 0.0005; // mm
constexpr double restSpeed = 0.1;       // mm/s
constexpr double sameAxis = 1e-6;       // rad: the axis has arrived
constexpr double near = 0.02;           // mm: counts as arrived, on the way to a stroke's start

/// Highest speed at a distance from the goal from which braking still ends there: proportional to the distance near the
/// goal, along the parabola of constant braking farther away.
double approachSpeed(double distance) {
    constexpr double braking = brakingShare * SimulatedStylus::acceleration;
    constexpr double linear = braking * SimulatedStylus::lag * SimulatedStylus::lag;
    if (distance <= linear) return distance / SimulatedStylus::lag;
    return std::sqrt(2.0 * braking * (distance - 0.5 * linear));
}

double lateralDistance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The smallest rotation that takes +z to an axis.
glm::dquat rotationTo(const glm::dvec3& axis) {
    if (axis == uprightAxis) return {1.0, 0.0, 0.0, 0.0};
    return glm::normalize(glm::dquat(1.0 + axis.z, -axis.y, axis.x, 0.0)); // half of the angle about z × axis
}

} // namespace

SimulatedStylus::SimulatedStylus(const glm::dvec3& start) : shown_{.tip = start}, tip_(start), hoverHeight_(start.z) {
    target_.tip = start;
}

bool SimulatedStylus::request(const StylusTarget& target) noexcept {
    if (target.cutting && requests_.size() + roomToEnd >= requests_.capacity()) return false;
    if (!target.cutting && !target.finishStroke) givenUp_.fetch_add(1, std::memory_order_relaxed);
    const bool taken = requests_.push({target, givenUp_.load(std::memory_order_relaxed)});
    if (taken && target.cutting) ++requested_;
    return taken;
}

glm::dvec3 SimulatedStylus::tip() noexcept {
    places_.take(shown_);
    return shown_.tip;
}

bool SimulatedStylus::strokeUnderWay() noexcept {
    places_.take(shown_);
    return shown_.strokeUnderWay;
}

std::uint64_t SimulatedStylus::strokesBegun() noexcept {
    places_.take(shown_);
    return shown_.begun;
}

std::size_t SimulatedStylus::targetsAhead() noexcept {
    places_.take(shown_);
    return shown_.targetsAhead + static_cast<std::size_t>(requested_ - shown_.taken);
}

StylusDescription SimulatedStylus::description() const {
    StylusDescription stylus;
    stylus.name = BURIN_TEXT("Device", "Mouse").text;
    const std::string touch = BURIN_TEXT("Device", "simulated: no force is felt; values of a 3D Systems Touch (CHAI3D "
                                                   "device table) scale the force that is shown")
                                  .text;
    const std::string own = "simulated: its positions are those of the setup";
    stylus.simulated = true;
    stylus.actuated = {3, 0};
    stylus.buttons = 1;
    stylus.maximumForce = {3.3, touch};
    stylus.maximumStiffness = {400.0, touch};
    stylus.maximumDamping = {4.0, touch};
    stylus.workspaceRadius = {5000.0, own};
    stylus.maximumSpeed = {2.5 * maximumSpeed, own};
    return stylus;
}

Result<void> SimulatedStylus::open() {
    lastTime_.reset();
    velocity_ = glm::dvec3(0.0);
    waiting_.reset();
    after_.reset();
    axis_ = uprightAxis;
    phase_ = Phase::hover;
    return {};
}

void SimulatedStylus::takeRequests() noexcept {
    const std::uint32_t givenUp = givenUp_.load(std::memory_order_relaxed);
    // it was requested before the stroke was given up
    if (std::exchange(givenUpSeen_, givenUp) != givenUp) waiting_.reset();
    for (int taken = 0; taken < mostTaken; ++taken) {
        if (!waiting_) {
            Request next;
            if (requests_.pop({&next, 1}) == 0) return;
            if (next.target.cutting) ++taken_;
            // Compared by difference: the counter may have wrapped, and newer requests may arrive in the meantime.
            if (static_cast<std::int32_t>(next.givenUp - givenUp) < 0) {
                --taken; // a dropped target does not count towards the limit
                continue;
            }
            next.target.maximumSpeed = std::clamp(next.target.maximumSpeed, 0.0, maximumSpeed);
            waiting_ = next.target;
        }
        if (!apply(*waiting_)) return;
        waiting_.reset();
    }
}

/// @return false if the target can't be followed yet
bool SimulatedStylus::apply(const StylusTarget& target) noexcept {
    if (!target.cutting) {
        if (phase_ != Phase::hover && target.finishStroke)
            after_ = target;
        else
            hoverOver(target);
        return true;
    }
    if (after_) return false; // belongs to the next stroke
    if (phase_ != Phase::hover) {
        if (!trail_.append(target.tip, target.grain, target.axis)) return false;
    } else {
        strokeStart_ = target.tip;
        hoverHeight_ = std::max(hoverHeight_, target.clearHeight);
        trail_.begin(strokeStart_, target.axis);
        phase_ = Phase::approach;
    }
    target_ = target;
    return true;
}

void SimulatedStylus::hoverOver(const StylusTarget& target) noexcept {
    target_ = target;
    hoverHeight_ = target.tip.z;
    after_.reset();
    phase_ = Phase::hover;
}

/// Above a position at a height that is clear, or on the way up to that height.
glm::dvec3 SimulatedStylus::above(const glm::dvec3& place) const noexcept {
    const double height = std::max(place.z, hoverHeight_);
    if (tip_.z < height - clearance) return {tip_.x, tip_.y, height};
    return {place.x, place.y, std::max(height, tip_.z)};
}

glm::dvec3 SimulatedStylus::goal() const noexcept {
    switch (phase_) {
    case Phase::hover:
        return lateralDistance(tip_, target_.tip) > near ? above(target_.tip) : target_.tip;
    case Phase::approach:
        return above(strokeStart_);
    case Phase::plunge:
    case Phase::follow:
        break;
    }
    return strokeStart_;
}

void SimulatedStylus::changePhase() noexcept {
    const bool still = glm::length(velocity_) < 20.0 * restSpeed;
    if (phase_ == Phase::approach && still && lateralDistance(tip_, strokeStart_) < near) {
        phase_ = Phase::plunge;
        ++begun_;
    }
    if (phase_ == Phase::plunge && still && tip_ == strokeStart_) phase_ = Phase::follow;
    if (phase_ == Phase::follow && after_ && trail_.finished()) hoverOver(*after_);
}

void SimulatedStylus::lean(double seconds) noexcept {
    const glm::dvec3 requested = phase_ == Phase::follow ? trail_.axis() : uprightAxis;
    if (axis_ == requested) return; // as always with the mouse
    const double share = 1.0 - std::exp(-seconds / turnLag), angle = angleBetween(axis_, requested);
    axis_ =
        angle < sameAxis ? requested : turnedTowards(axis_, requested, std::min(share * angle, turnSpeed * seconds));
}

void SimulatedStylus::step(double seconds) noexcept {
    lean(seconds);
    if (phase_ == Phase::follow) {
        tip_ = trail_.step(seconds, target_.maximumSpeed);
        velocity_ = trail_.velocity();
        changePhase();
        return;
    }
    const glm::dvec3 way = goal() - tip_;
    const double distance = glm::length(way);
    if (distance < restDistance && glm::length(velocity_) < restSpeed) {
        tip_ += way;
        velocity_ = glm::dvec3(0.0);
    } else {
        const double speed = std::min(target_.maximumSpeed, approachSpeed(distance));
        const glm::dvec3 wanted = distance > 0.0 ? way * (speed / distance) : glm::dvec3(0.0);
        velocity_ += clampLength(wanted - velocity_, acceleration * seconds);
        tip_ += velocity_ * seconds;
    }
    changePhase();
}

StylusState SimulatedStylus::read(double time) noexcept {
    takeRequests();
    double gap = lastTime_ ? std::clamp(time - *lastTime_, 0.0, longestGap) : 0.0;
    lastTime_ = time;
    for (; gap > 0.0; gap -= longestStep) step(std::min(gap, longestStep));
    const std::size_t waits = waiting_ && waiting_->cutting ? 1 : 0;
    places_.post({tip_, phase_ != Phase::hover, phase_ == Phase::hover ? 0 : trail_.ahead() + waits, taken_, begun_});
    StylusState state;
    state.time = time;
    state.pose = {tip_, rotationTo(axis_)};
    state.buttons = phase_ == Phase::plunge || phase_ == Phase::follow ? 1U : 0U;
    state.valid = true;
    return state;
}

void SimulatedStylus::write(const Wrench& /*wrench*/) noexcept {}
void SimulatedStylus::close() noexcept {}

} // namespace burin
