// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/turn_coupling.h"

#include "core/haptics/boundary/pose_vector.h"
#include "core/haptics/force/coupling.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double believedTurn = 5.0;  // rad/s
constexpr double slowestTurn = 0.002; // rad/s: the tip of a pen of 50 mm moves by 0.1 mm/s

bool turnsTheHand(const StylusDescription& stylus) noexcept {
    return stylus.actuated.rotations > 0;
}

/// The share of its stiffness that limits of the gains leave to the coupling: what makes the one spring too stiff makes
/// the other one so as well.
double softened(const HapticSettings& settings) noexcept {
    const double full = couplingGains(settings.stylus, settings.couplingShare, settings.tickPeriod).stiffness;
    return full > 0.0 ? boundaryGains(settings).stiffness / full : 1.0;
}

double stiffnessOf(const HapticSettings& settings) noexcept {
    if (!turnsTheHand(settings.stylus)) return 0.0;
    return settings.couplingShare * settings.stylus.maximumTurningStiffness.value *
           std::min(1.0, ratedPeriod / settings.tickPeriod) * softened(settings);
}

PassivityController::Settings controllerSettings(const HapticSettings& settings) noexcept {
    const double delay = settings.stylus.delay.value;
    const double loss = sampledSpringLoss(stiffnessOf(settings), settings.tickPeriod, delay);
    return {loss, loss, slowestTurn, std::lround(delay / settings.tickPeriod)};
}

} // namespace

TurnCoupling::TurnCoupling(const HapticSettings& settings) noexcept
    : stiffness_(stiffnessOf(settings))
    , maximum_(turnsTheHand(settings.stylus) ? settings.forceShare * settings.stylus.maximumTorque.value : 0.0)
    , slew_(stiffness_ * believedTurn * settings.tickPeriod)
    , passivity_(controllerSettings(settings))
    , turning_(settings.stylus.rotationStep.value) {}

glm::dvec3 TurnCoupling::torque(const glm::dvec3& turnBehind, const glm::dquat& hand, double period) noexcept {
    const glm::dvec3 passive = passivity_.dampen(stiffness_ * turnBehind, motionOf(hand, period), period);
    const glm::dvec3 wanted = clampLength(passive, maximum());
    last_ = clampLength(last_ + clampLength(wanted - last_, slew_), maximum());
    return last_;
}

PassivityController::Motion TurnCoupling::motionOf(const glm::dquat& hand, double period) noexcept {
    PassivityController::Motion motion;
    if (hand_) motion.moved = turnBetween(*hand_, hand);
    hand_ = hand;
    angle_ += motion.moved;
    turning_.add(angle_, period);
    motion.velocity = turning_.velocity();
    motion.rests = turning_.rests();
    return motion;
}

void TurnCoupling::reset() noexcept {
    last_ = glm::dvec3(0.0);
    passivity_.reset();
    turning_.reset();
    hand_.reset();
    angle_ = glm::dvec3(0.0);
}

} // namespace burin
