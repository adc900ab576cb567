// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/cutting_force_rendering.h"

#include "core/base/units.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double turning = 0.3;    // mm of motion after which a direction is forgotten: several encoder steps
constexpr double slowest = 1.0;    // mm/s; lower speeds count as rest
constexpr double plainSpeed = 5.0; // mm/s; from this speed on it counts as moving
constexpr double settling = 0.02;  // s
// s: if a fast hand passes a voxel in a few ticks, the removed volume is not continuous any more but arrives in rows of
// scanlines.
constexpr double areaSmoothing = 0.015;

double newtonPerMillimetre(const CuttingForceRendering::Settings& settings) noexcept {
    return settings.stiffness / (settings.workspaceScale * millimetresPerMetre);
}

} // namespace

CuttingForceRendering::CuttingForceRendering(const Settings& settings) noexcept
    : settings_(settings), anchor_(newtonPerMillimetre(settings), settings.maximum), smoothing_(stepSmoothing()) {}

double CuttingForceRendering::stepSmoothing() const noexcept {
    constexpr double quiet = 0.004, tick = 0.001, longest = 0.005; // N, s, s
    const double stepForce = settings_.stiffness * settings_.positionStep / millimetresPerMetre;
    return std::min(tick * stepForce / quiet, longest);
}

void CuttingForceRendering::reset() noexcept {
    anchor_.reset();
    behind_ = glm::dvec3(0.0);
    area_ = 0.0;
    heading_ = away_ = glm::dvec3(0.0);
    startsMoving_ = moves_ = 0.0;
}

void CuttingForceRendering::setWorkspaceScale(double scale) noexcept {
    if (scale == settings_.workspaceScale) return;
    settings_.workspaceScale = scale;
    anchor_.setStiffness(newtonPerMillimetre(settings_));
}

double CuttingForceRendering::scale(const CuttingForce& cut) const noexcept {
    return cut.reference > 0.0 ? settings_.gain * referenceShare * settings_.maximum / cut.reference : 0.0;
}

void CuttingForceRendering::followDirections(const CuttingForce& cut, const Tick& tick) noexcept {
    const double way = glm::length(tick.motion), share = 1.0 - std::exp(-way / turning);
    if (way > 0.0) {
        heading_ += share * (tick.motion / way - heading_);
        away_ += share * (cut.radialRatio * cut.away - away_);
    }
    const double speed = glm::length(tick.velocity);
    const double moving = std::clamp((speed - slowest) / (plainSpeed - slowest), 0.0, 1.0);
    const double settled = 1.0 - std::exp(-tick.period / settling);
    startsMoving_ += settled * (moving - startsMoving_);
    moves_ += settled * (startsMoving_ - moves_);
    // Below any device's resolution; without this limit the decay would end in denormal numbers, which are slow.
    constexpr double nothing = 1e-12;
    if (startsMoving_ < nothing) startsMoving_ = 0.0;
    if (moves_ < nothing) moves_ = 0.0;
}

glm::dvec3 CuttingForceRendering::render(const CuttingForce& cut, const Tick& tick) noexcept {
    followDirections(cut, tick);
    area_ += (1.0 - std::exp(-tick.period / areaSmoothing)) * (cut.area - area_);
    const double share = smoothing_ > 0.0 ? 1.0 - std::exp(-tick.period / smoothing_) : 1.0;
    behind_ += tick.motion;
    const glm::dvec3 motion = share * behind_;
    behind_ -= motion;
    const double tangential = scale(cut) * newtonMillimetresPerJoule * cut.energy * area_;
    const double length = glm::length(heading_);
    const glm::dvec3 against = length > 0.0 ? -heading_ / length : glm::dvec3(0.0);
    const double alongShare = glm::dot(away_, against);
    const double resistance = std::max(0.0, tangential * (1.0 + alongShare));
    const double yield = std::min(resistance + settings_.friction * tick.load, settings_.maximum);
    const glm::dvec3 held = anchor_.drag(motion, {yield, tick.normal, std::min(resistance, settings_.maximum)});
    const glm::dvec3 sideways = tangential * moves_ * (away_ - alongShare * against);
    return clampLength(held + sideways, settings_.maximum);
}

glm::dvec3 besideHeld(const glm::dvec3& held, const glm::dvec3& cutting, double maximum) noexcept {
    const double square = glm::dot(cutting, cutting);
    if (!(square > 0.0)) return glm::dvec3(0.0);
    // |held + share · cutting| = maximum
    const double along = glm::dot(held, cutting) / square;
    const double room = (maximum * maximum - glm::dot(held, held)) / square + along * along;
    return std::clamp(std::sqrt(std::max(0.0, room)) - along, 0.0, 1.0) * cutting;
}

} // namespace burin
