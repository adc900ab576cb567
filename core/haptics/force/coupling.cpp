// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/coupling.h"

#include "core/base/units.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double restingShare = 0.6; // of the damping that the spring takes
constexpr double lagMargin = 0.6;    // of handle mass over lag; from 1 on the damper oscillates

} // namespace

double usableDamping(const StylusDescription& stylus, double period) noexcept {
    if (!stylus.hasMotors()) return 0.0;
    return usableDamping(stylus.maximumDamping.value, lightHandle, period + stylus.delay.value);
}

double usableDamping(double most, double mass, double lag) noexcept {
    return std::min(most, lagMargin * mass / lag);
}

double sampledSpringLoss(double stiffness, double period, double delay) noexcept {
    return stiffness * (0.5 * period + delay);
}

CouplingGains couplingGains(const StylusDescription& stylus, double share, double period,
                            const GainLimits& limits) noexcept {
    if (!stylus.hasMotors()) return {};
    const double slower = std::min(1.0, 0.5 * ratedPeriod / (0.5 * period + stylus.delay.value));
    CouplingGains gains;
    gains.stiffness = std::min(share * stylus.maximumStiffness.value * slower, limits.stiffness);
    gains.damping = std::min(dampingShare * usableDamping(stylus, period), limits.damping);
    gains.restingDamping = std::min(gains.damping, restingShare * sampledSpringLoss(gains.stiffness, period, 0.0));
    return gains;
}

CouplingGains boundaryGains(const HapticSettings& settings) noexcept {
    return couplingGains(settings.stylus, settings.couplingShare, settings.tickPeriod, settings.gains);
}

CouplingGains guideGains(const HapticSettings& settings) noexcept {
    const GainLimits limits{settings.gains.stiffness * settings.guideShare / settings.couplingShare,
                            settings.gains.damping};
    return couplingGains(settings.stylus, settings.guideShare, settings.tickPeriod, limits);
}

glm::dvec3 Coupling::force(const State& state) const noexcept {
    const double parting = glm::dot(state.handVelocity - state.proxyVelocity, state.normal);
    return force(state.proxy - state.hand, parting * state.normal, state.rests);
}

glm::dvec3 Coupling::force(const glm::dvec3& pull, const glm::dvec3& speed, bool rests) const noexcept {
    const double metresOfDevice = 1.0 / (scale_ * millimetresPerMetre);
    const double damping = rests ? gains_.restingDamping : gains_.damping;
    return metresOfDevice * (gains_.stiffness * pull - damping * speed);
}

} // namespace burin
