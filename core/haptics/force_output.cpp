// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force_output.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double cuttingShare = 0.6; // of the force that is allowed at all

CuttingForceRendering::Settings renderingSettings(const HapticSettings& settings, double stiffness) noexcept {
    return {settings.cuttingForceScale, stiffness, cuttingShare * settings.maximumForce(), settings.mapping.scale};
}

PassivityController::Settings controllerSettings(const HapticSettings& settings, double stiffness) noexcept {
    const StylusDescription& stylus = settings.stylus;
    const double damping = usableDamping(stylus, settings.tickPeriod);
    const double loss = sampledSpringLoss(stiffness, settings.tickPeriod, 0.0);
    return {damping, std::min(damping, loss), std::lround(stylus.delay.value / settings.tickPeriod)};
}

} // namespace

ForceOutput::ForceOutput(const HapticSettings& settings) noexcept
    : coupling_(couplingGains(settings.stylus, settings.couplingShare, settings.tickPeriod), settings.mapping.scale)
    , guideSpring_(couplingGains(settings.stylus, settings.guideShare, settings.tickPeriod), settings.mapping.scale)
    , turnCoupling_(settings)
    , cuttingRendering_(renderingSettings(settings, coupling_.stiffness()))
    , passivity_(controllerSettings(settings, coupling_.stiffness()))
    , limiter_(settings.maximumForce(), coupling_.stiffness(), settings.tickPeriod)
    , ramp_(settings.rampSeconds)
    , toolMotion_(settings.stylus.positionStep.value * settings.mapping.scale) {}

void ForceOutput::operator()(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                             const GuidedHand& guided, double period, Sample& sample) noexcept {
    toolMotion_.add(motion.to.tip, period);
    for (Coupling* spring : {&coupling_, &guideSpring_}) spring->setScale(hand.mapping.scale);
    cuttingRendering_.setWorkspaceScale(hand.mapping.scale);
    const glm::dvec3 inDevice = hand.mapping.directionToDevice(wanted(motion, cutting, hand, guided, period));
    const glm::dvec3 turn = hand.clutched ? glm::dvec3(0.0) : motion.turnBehind;
    const glm::dvec3 turning = hand.mapping.directionToDevice(turnCoupling_.torque(turn));
    if (hand.reading == Reading::late || !isFinite(inDevice) || !isFinite(turning)) {
        none(hand.reading != Reading::late, sample);
        return;
    }
    const glm::dvec3 passive = passivity_(inDevice, hand, period);
    wrench_.force = limiter_(passive) * ramp_.weight();
    wrench_.torque = turning * ramp_.weight();
    passivity_.sent(wrench_.force);
    sample.force = hand.mapping.directionToSetup(wrench_.force);
    if (limiter_.saturated() && limiter_.maximum() > 0.0) sample.flags |= sampleForceSaturated;
    if (!ramp_.complete()) sample.flags |= sampleForcesOff;
    ramp_.advance(period);
}

glm::dvec3 ForceOutput::wanted(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                               const GuidedHand& guided, double period) noexcept {
    if (hand.clutched) {
        cuttingRendering_.reset();
        return glm::dvec3(0.0);
    }
    const FeltGuides guides = felt(guided, hand.wanted.tip, motion.to.tip);
    Coupling::State state;
    state.proxy = motion.to.tip;
    state.hand = guides.from;
    state.proxyVelocity = toolMotion_.velocity();
    state.handVelocity = hand.velocity;
    state.normal = motion.normal;
    state.rests = hand.rests;
    const glm::dvec3 away = state.proxy - state.hand;
    if (motion.barred && glm::length(away) > 1e-6) state.normal = glm::normalize(away);
    return coupling_.force(state) + guideSpring_.force(guides.pull, guides.across, hand.rests) +
           cuttingRendering_(cutting, motion.way(), motion.to.tip, period);
}

bool ForceOutput::quiet() const noexcept {
    constexpr double felt = 0.02; // N: what a desktop device can render and a hand notice
    return glm::length(wrench_.force) < felt;
}

void ForceOutput::none(bool fadesIn, Sample& sample) noexcept {
    wrench_ = {};
    sample.force = glm::dvec3(0.0);
    sample.flags |= sampleForcesOff;
    turnCoupling_.reset();
    limiter_.reset();
    passivity_.reset();
    if (fadesIn) fadeIn();
}

void ForceOutput::fadeIn() noexcept {
    wrench_ = {};
    turnCoupling_.reset();
    limiter_.reset();
    passivity_.reset();
    ramp_.restart();
    cuttingRendering_.reset();
    toolMotion_.reset();
}

} // namespace burin
