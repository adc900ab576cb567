// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/turn_coupling.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double ratedPeriod = 0.001; // s, that a stylus states its stiffness for
constexpr double believedTurn = 5.0;  // rad/s

bool turnsTheHand(const StylusDescription& stylus) noexcept {
    return stylus.actuated.rotations > 0;
}

} // namespace

TurnCoupling::TurnCoupling(const HapticSettings& settings) noexcept
    : stiffness_(turnsTheHand(settings.stylus)
                     ? settings.couplingShare * settings.stylus.maximumTurningStiffness.value *
                           std::min(1.0, ratedPeriod / settings.tickPeriod)
                     : 0.0)
    , maximum_(turnsTheHand(settings.stylus) ? settings.forceShare * settings.stylus.maximumTorque.value : 0.0)
    , slew_(stiffness_ * believedTurn * settings.tickPeriod) {}

glm::dvec3 TurnCoupling::torque(const glm::dvec3& turnBehind) noexcept {
    const glm::dvec3 wanted = clampLength(stiffness_ * turnBehind, maximum());
    last_ = clampLength(last_ + clampLength(wanted - last_, slew_), maximum());
    return last_;
}

} // namespace burin
