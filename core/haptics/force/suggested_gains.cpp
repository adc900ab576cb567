// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/suggested_gains.h"

#include "core/base/units.h"
#include "core/haptics/force/coupling.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr std::uint64_t fewestReadings = 200; // for the interval that 99 of 100 do not exceed

/// The largest of the three parts of the lag of a force.
GainBound slowest(const SuggestedGains& gains) noexcept {
    const double held = 0.5 * (gains.hold - gains.jitter), late = 0.5 * gains.jitter;
    if (gains.latency >= std::max(held, late)) return GainBound::latency;
    return late > held ? GainBound::jitter : GainBound::rate;
}

void bound(SuggestedGains& gains, double stiffness, GainBound by) noexcept {
    if (!(stiffness < gains.stiffness)) return;
    gains.stiffness = stiffness;
    gains.bound = by;
}

double massOf(const StylusDescription& stylus) noexcept {
    return stylus.handleMass.value > 0.0 ? std::min(stylus.handleMass.value, lightHandle) : lightHandle;
}

} // namespace

std::optional<SuggestedGains> suggestGains(const StylusDescription& stylus, const TrialFigures& trial,
                                           const GainRequest& request) noexcept {
    if (stylus.actuated.translations == 0 || !(stylus.maximumStiffness.value > 0.0)) return std::nullopt;
    if (trial.readings < fewestReadings || !(trial.usualInterval > 0.0)) return std::nullopt;
    SuggestedGains gains;
    gains.hold = trial.usualInterval;
    gains.jitter = std::max(0.0, trial.usualInterval - trial.medianInterval);
    gains.latencyMeasured = trial.latency > 0.0;
    gains.latency = std::max(stylus.delay.value, trial.latency);
    gains.step = stylus.positionStep.value > 0.0 ? stylus.positionStep.value : trial.smallestStep;
    gains.friction = request.friction;

    gains.stiffness = HapticSettings::safeShare * stylus.maximumStiffness.value;
    const double damping = sampledSpringLoss(stylus.maximumStiffness.value, ratedPeriod, 0.0);
    bound(gains, HapticSettings::safeShare * damping / sampledSpringLoss(1.0, gains.hold, gains.latency),
          slowest(gains));
    if (gains.friction > 0.0 && gains.step > 0.0)
        bound(gains, HapticSettings::safeShare * 2.0 * gains.friction / (gains.step / millimetresPerMetre),
              GainBound::encoders);
    bound(gains, request.ceiling, GainBound::ceiling);
    gains.damping =
        dampingShare * usableDamping(stylus.maximumDamping.value, massOf(stylus), gains.hold + gains.latency);
    return gains;
}

GainLimits KeptGains::inForce() const noexcept {
    return {std::min(now.stiffness, request.ceiling), now.damping};
}

void KeptGains::use(const GainLimits& limits) noexcept {
    if (limits == now) return;
    before = std::exchange(now, limits);
}

void KeptGains::restore() noexcept {
    std::swap(now, before);
}

} // namespace burin
