// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/operator_hand.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace burin {

HandArm::HandArm(const HandImpedance& hand, const HandleInertia& handle, const HandReaction& reaction,
                 double step) noexcept
    : mass_(hand.mass + handle.mass)
    , damping_(hand.damping + handle.damping)
    , stiffness_(hand.stiffness)
    , longestStep_(step >= finestStep ? step : finestStep)
    , reaction_(reaction) {}

glm::dvec3 HandArm::accelerationAt(const glm::dvec3& deviation, const glm::dvec3& velocity,
                                   const glm::dvec3& force) const noexcept {
    // N·s/m times mm/s and N/m times mm are mN, and mN / kg is mm/s².
    return (force * millimetresPerMetre - damping_ * velocity - stiffness_ * deviation) / mass_;
}

void HandArm::step(const glm::dvec3& force, double h) noexcept {
    const glm::dvec3 v1 = velocity_;
    const glm::dvec3 a1 = accelerationAt(deviation_, v1, force);
    const glm::dvec3 v2 = velocity_ + 0.5 * h * a1;
    const glm::dvec3 a2 = accelerationAt(deviation_ + 0.5 * h * v1, v2, force);
    const glm::dvec3 v3 = velocity_ + 0.5 * h * a2;
    const glm::dvec3 a3 = accelerationAt(deviation_ + 0.5 * h * v2, v3, force);
    const glm::dvec3 v4 = velocity_ + h * a3;
    const glm::dvec3 a4 = accelerationAt(deviation_ + h * v3, v4, force);
    deviation_ += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    velocity_ += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

void HandArm::advance(const glm::dvec3& force, double seconds) noexcept {
    if (reaction_.share > 0.0)
        leaning_ += (-reaction_.share * force - leaning_) * (1.0 - std::exp(-seconds / reaction_.seconds));
    const int steps = std::max(1, static_cast<int>(std::ceil(seconds / longestStep_ - 1e-9)));
    for (int i = 0; i < steps; ++i) step(force + leaning_, seconds / steps);
}

void HandArm::stopAt(const glm::dvec3& deviation, const glm::dvec3& outward) noexcept {
    deviation_ = deviation;
    velocity_ -= std::max(0.0, glm::dot(velocity_, outward)) * outward;
}

void HandArm::reset() noexcept {
    deviation_ = velocity_ = leaning_ = glm::dvec3(0.0);
}

Tremor::Tremor(double rms, std::uint64_t seed) noexcept : amplitude_(rms * std::sqrt(2.0 / wavesPerAxis)) {
    std::mt19937_64 generator(seed);
    // The standard's distributions may differ between libraries; its generators may not.
    const auto share = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
    // One wave in each equal part of the band: no two have nearly the same frequency, as their slow beat would change
    // the rms.
    constexpr double part = (highestFrequency - lowestFrequency) / wavesPerAxis;
    for (auto& axis : waves_)
        for (int i = 0; i < wavesPerAxis; ++i) {
            const double frequency = lowestFrequency + part * (i + 0.25 + 0.5 * share());
            axis[static_cast<std::size_t>(i)] = {2.0 * pi * frequency, 2.0 * pi * share()};
        }
}

glm::dvec3 Tremor::at(double time) const noexcept {
    if (amplitude_ == 0.0) return glm::dvec3(0.0);
    glm::dvec3 place(0.0);
    for (int axis = 0; axis < 3; ++axis)
        for (const Wave& wave : waves_[static_cast<std::size_t>(axis)])
            place[axis] += amplitude_ * std::sin(wave.angularFrequency * time + wave.phase);
    return place;
}

} // namespace burin
