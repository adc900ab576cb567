// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/coupling.h"

#include "core/base/units.h"
#include "core/haptics/velocity_window.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double ratedPeriod = 0.001; // s, that a stylus states its stiffness for
constexpr double dampingShare = 0.3;
constexpr double lightHandle = 0.1; // kg
constexpr double lagMargin = 0.6;   // of handle mass over lag; from 1 on the damper oscillates

} // namespace

double usableDamping(const StylusDescription& stylus) noexcept {
    if (!stylus.hasMotors()) return 0.0;
    return std::min(stylus.maximumDamping.value, lagMargin * lightHandle / (0.5 * VelocityWindow::length));
}

CouplingGains couplingGains(const StylusDescription& stylus, double share, double period) noexcept {
    if (!stylus.hasMotors()) return {};
    const double slower = std::min(1.0, ratedPeriod / period);
    return {share * stylus.maximumStiffness.value * slower, dampingShare * usableDamping(stylus)};
}

glm::dvec3 Coupling::force(const State& state) const noexcept {
    const double parting = glm::dot(state.handVelocity - state.proxyVelocity, state.normal);
    return force(state.proxy - state.hand, parting * state.normal);
}

glm::dvec3 Coupling::force(const glm::dvec3& pull, const glm::dvec3& speed) const noexcept {
    const double metresOfDevice = 1.0 / (scale_ * millimetresPerMetre);
    return metresOfDevice * (gains_.stiffness * pull - gains_.damping * speed);
}

} // namespace burin
