// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/simulated_stylus.h"

#include "core/base/text.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double brakingShare = 0.8;    // of the acceleration: the rest keeps a moving goal from being overrun
constexpr double longestStep = 0.001;   // s
constexpr double longestGap = 0.010;    // s
constexpr double restDistance = 0.0005; // mm
constexpr double restSpeed = 0.1;       // mm/s
constexpr double near = 0.02;           // mm: counts as there, on the way to a stroke's start

/// Fastest speed at a distance from the goal from which braking still ends there: proportional to the distance near
/// it, along the parabola of constant braking farther off.
double approachSpeed(double distance) {
    constexpr double braking = brakingShare * SimulatedStylus::acceleration;
    constexpr double linear = braking * SimulatedStylus::lag * SimulatedStylus::lag;
    if (distance <= linear) return distance / SimulatedStylus::lag;
    return std::sqrt(2.0 * braking * (distance - 0.5 * linear));
}

double lateralDistance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

} // namespace

SimulatedStylus::SimulatedStylus(const glm::dvec3& start) : shownTip_(start), tip_(start), hoverHeight_(start.z) {
    target_.tip = start;
}

void SimulatedStylus::wish(const StylusTarget& target) noexcept {
    wishes_.post(target);
}

glm::dvec3 SimulatedStylus::tip() noexcept {
    places_.take(shownTip_);
    return shownTip_;
}

StylusDescription SimulatedStylus::description() const {
    StylusDescription stylus;
    stylus.name = BURIN_TEXT("Device", "Mouse").text;
    const std::string touch = BURIN_TEXT("Device", "simulated: no force is felt; figures of a 3D Systems Touch (CHAI3D "
                                                   "device table) scale the force that is shown")
                                  .text;
    const std::string own = "simulated: the whole bench, its positions are the setup's own";
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
    phase_ = Phase::hover;
    return {};
}

void SimulatedStylus::takeWish() noexcept {
    if (!wishes_.take(target_)) return;
    target_.maximumSpeed = std::clamp(target_.maximumSpeed, 0.0, maximumSpeed);
    if (!target_.cutting) {
        hoverHeight_ = target_.tip.z;
        phase_ = Phase::hover;
    } else if (phase_ == Phase::hover) {
        strokeStart_ = target_.tip;
        hoverHeight_ = std::max(hoverHeight_, target_.clearHeight);
        phase_ = Phase::approach;
    }
}

/// Over a place at a height that is clear, or on the way up to that height.
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
        return strokeStart_;
    case Phase::follow:
        break;
    }
    return target_.tip;
}

void SimulatedStylus::changePhase() noexcept {
    const bool still = glm::length(velocity_) < 20.0 * restSpeed;
    if (phase_ == Phase::approach && still && lateralDistance(tip_, strokeStart_) < near) phase_ = Phase::plunge;
    if (phase_ == Phase::plunge && still && glm::length(tip_ - strokeStart_) < near) phase_ = Phase::follow;
}

void SimulatedStylus::step(double seconds) noexcept {
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
    takeWish();
    double gap = lastTime_ ? std::clamp(time - *lastTime_, 0.0, longestGap) : 0.0;
    lastTime_ = time;
    for (; gap > 0.0; gap -= longestStep) step(std::min(gap, longestStep));
    places_.post(tip_);
    StylusState state;
    state.time = time;
    state.pose.position = tip_;
    state.buttons = phase_ == Phase::plunge || phase_ == Phase::follow ? 1U : 0U;
    state.valid = true;
    return state;
}

void SimulatedStylus::write(const Wrench& /*wrench*/) noexcept {}
void SimulatedStylus::close() noexcept {}

} // namespace burin
