// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/assist_output.h"

#include "core/base/units.h"
#include "core/haptics/force/cutting_force_rendering.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

double ceilingOf(const HapticSettings& settings) noexcept {
    const double ceiling = settings.felt.assist;
    return settings.stylus.assist.works() && ceiling > 0.0 ? std::min(ceiling, 1.0) : 0.0; // NaN: 0
}

std::uint32_t holdButtonsOf(const HapticSettings& settings) noexcept {
    constexpr std::uint32_t first = 1;
    if (settings.stylus.assist.forceAxes == 0) return 0;
    return settings.forceButtons != 0 ? settings.forceButtons : first;
}

/// Share of the ceiling.
double loadOf(const CuttingForce& cutting, double gain) noexcept {
    if (!cutting.cuts || !(cutting.reference > 0.0)) return 0.0;
    const double force = newtonMillimetresPerJoule * cutting.energy * cutting.area; // N
    return std::clamp(gain * CuttingForceRendering::referenceShare * force / cutting.reference, 0.0, 1.0);
}

/// 0 … 1. @param speed mm/s
double moving(double speed) noexcept {
    constexpr double slowest = 1.0, plain = 5.0; // mm/s, as for forces that are felt (CuttingForceRendering)
    return std::clamp((speed - slowest) / (plain - slowest), 0.0, 1.0);
}

bool heldBySomething(const ToolMotion& motion) noexcept {
    return motion.normal != glm::dvec3(0.0) || motion.barred || motion.shankContact;
}

double towards(double from, double to, double rise, double fall) noexcept {
    return from + std::clamp(to - from, -fall, rise);
}

} // namespace

AssistOutput::AssistOutput(const HapticSettings& settings) noexcept
    : ceiling_(ceilingOf(settings)), gain_(settings.felt.gain), holdButtons_(holdButtonsOf(settings)) {}

AssistOutput::Shares AssistOutput::sharesOf(const glm::dvec3& away, const ToolMotion& motion,
                                            const CuttingForce& cutting, const Hand& hand, double period) noexcept {
    Shares shares;
    glm::dvec3 cuts(0.0);
    if (const double moved = glm::length(cutting.motion); moved > 0.0 && !hand.clutched)
        cuts = -loadOf(cutting, gain_) * moving(moved / period) * cutting.motion / moved;
    cutting_ += (1.0 - std::exp(-period / settling)) * (cuts - cutting_);
    if (!isFinite(cutting_)) cutting_ = glm::dvec3(0.0);
    if (heldBySomething(motion) && !hand.clutched && isFinite(away))
        shares.contact = clampLength(away / (fullDepth * hand.mapping.scale), 1.0);
    shares.cutting = besideHeld(shares.contact, cutting_, 1.0);
    return shares;
}

Assist AssistOutput::advance(const glm::dvec3& away, const ToolMotion& motion, const CuttingForce& cutting,
                             const Hand& hand, double weight, double period) noexcept {
    const Shares shares = sharesOf(away, motion, cutting, hand, period);
    const double strength = ceiling_ * weight;
    const double rise = ceiling_ * period / riseSeconds, fall = ceiling_ * period / fallSeconds;
    const bool held = holdButtons_ == 0 || (hand.buttons & holdButtons_) != 0;
    const glm::dvec3 inSetup = held ? strength * (shares.contact + shares.cutting) : glm::dvec3(0.0);
    const glm::dvec3 push = hand.mapping.directionToDevice(inSetup);
    const bool grows = glm::dot(push, push) >= glm::dot(shown_.force, shown_.force);
    shown_.force += clampLength(push - shown_.force, grows ? rise : fall);
    shown_.contact = towards(shown_.contact, strength * glm::length(shares.contact), rise, fall);
    shown_.load = towards(shown_.load, strength * glm::length(cutting_), rise, fall);
    shown_.ceiling = ceiling_;
    return shown_;
}

Assist AssistOutput::none() noexcept {
    cutting_ = glm::dvec3(0.0);
    shown_ = {};
    shown_.ceiling = ceiling_;
    return shown_;
}

} // namespace burin
