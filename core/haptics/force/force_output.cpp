// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/force_output.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

CuttingForceRendering::Settings renderingSettings(const HapticSettings& settings, double stiffness) noexcept {
    return {settings.felt.gain,      stiffness,
            settings.maximumForce(), settings.felt.friction,
            settings.mapping.scale,  settings.stylus.positionStep.value};
}

PassivityController::Settings controllerSettings(const HapticSettings& settings, double stiffness) noexcept {
    const StylusDescription& stylus = settings.stylus;
    constexpr double slowest = 0.1;                                                          // mm/s
    const double damping = usableDamping(stylus, settings.tickPeriod) / millimetresPerMetre; // N·s/mm
    const double loss = sampledSpringLoss(stiffness, settings.tickPeriod, 0.0) / millimetresPerMetre;
    return {damping, std::min(damping, loss), slowest, std::lround(stylus.delay.value / settings.tickPeriod)};
}

constexpr double liftStep = 0.05; // N per tick: a third of the slowest slew, in addition to the felt forces

/// Weight that the motors have to lift, N.
double weightOf(const StylusDescription& stylus) noexcept {
    constexpr double standardGravity = 9.80665; // m/s²
    return stylus.carriesHandle || stylus.actuated.translations < 3 ? 0.0 : stylus.handleMass.value * standardGravity;
}

/// Force that carries the handle, N, device frame. No more than half of the maximum: the rest is for the felt forces.
glm::dvec3 liftOf(double weight, double maximum) noexcept {
    constexpr double most = 0.5;
    return {0.0, 0.0, std::min(weight, most * maximum)};
}

} // namespace

ForceOutput::ForceOutput(const HapticSettings& settings) noexcept
    : assist_(settings)
    , coupling_(boundaryGains(settings), settings.mapping.scale)
    , guideSpring_(guideGains(settings), settings.mapping.scale)
    , turnCoupling_(settings)
    , cuttingRendering_(renderingSettings(settings, coupling_.stiffness()))
    , passivity_(controllerSettings(settings, coupling_.stiffness()))
    , maximum_(settings.maximumForce())
    , weight_(weightOf(settings.stylus))
    , lift_(liftOf(weight_, maximum_))
    , limiter_(maximum_ - glm::length(lift_), coupling_.stiffness(), settings.tickPeriod)
    , ramp_(settings.rampSeconds)
    , toolMotion_(settings.stylus.positionStep.value * settings.mapping.scale)
    , forceButtons_(settings.forceButtons) {}

void ForceOutput::render(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                         const GuidedHand& guided, double period, Sample& sample) noexcept {
    toolMotion_.add(motion.to.tip, period);
    for (Coupling* spring : {&coupling_, &guideSpring_}) spring->setScale(hand.mapping.scale);
    cuttingRendering_.setWorkspaceScale(hand.mapping.scale);
    const glm::dvec3 inDevice = hand.mapping.directionToDevice(wanted(motion, cutting, hand, guided, period));
    const glm::dvec3 turn = hand.clutched ? glm::dvec3(0.0) : motion.turnBehind;
    const glm::dvec3 turning = turnCoupling_.torque(hand.mapping.directionToDevice(turn), hand.device.rotation, period);
    const bool letGo = forceButtons_ != 0 && (hand.buttons & forceButtons_) == 0;
    if (hand.reading == Reading::late || letGo || !isFinite(inDevice) || !isFinite(turning)) {
        none(letGo || hand.reading != Reading::late, sample);
        return;
    }
    const glm::dvec3 passive = passivity_.dampen(inDevice, motionOf(hand), period);
    rendered_ = limiter_.limit(passive) * ramp_.weight();
    lifted_ += clampLength(lift_ - lifted_, liftStep);
    wrench_.force = rendered_ + lifted_ * ramp_.weight();
    wrench_.torque = turning * ramp_.weight();
    if (assist_.active()) {
        const glm::dvec3 away = motion.to.tip - felt(guided, hand.wanted.tip, motion.to.tip).from;
        wrench_.assist = assist_.advance(away, motion, cutting, hand, ramp_.weight(), period);
    }
    // A lift does no work except against the handle's own weight: it does not count as energy of the loop.
    passivity_.sent(rendered_);
    turnCoupling_.sent(wrench_.torque);
    sample.force = hand.mapping.directionToSetup(rendered_);
    sample.torque = hand.mapping.directionToSetup(wrench_.torque);
    if ((limiter_.saturated() || cuttingGaveWay_) && limiter_.maximum() > 0.0) sample.flags |= sampleForceSaturated;
    if (!ramp_.complete()) sample.flags |= sampleForcesOff;
    if (relief_.active()) sample.flags |= sampleMotorsHot;
    ramp_.advance(period);
}

PassivityController::Motion ForceOutput::motionOf(const Hand& hand) noexcept {
    const glm::dvec3 place = hand.device.position;
    const glm::dvec3 before = handPlace_.value_or(place);
    handPlace_ = place;
    return {place - before, hand.deviceVelocity, hand.rests};
}

void ForceOutput::motorsAre(double heat, double period) noexcept {
    const double before = relief_.share();
    relief_.advance(heat, period);
    const double share = relief_.share();
    if (share == before) return;
    lift_ = liftOf(weight_, share * maximum_);
    limiter_.setMaximum(share * maximum_ - glm::length(lift_));
    turnCoupling_.setShare(share);
}

glm::dvec3 ForceOutput::wanted(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand,
                               const GuidedHand& guided, double period) noexcept {
    cuttingGaveWay_ = false;
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
    const glm::dvec3 contact = coupling_.force(state);
    const double load = std::max(0.0, glm::dot(contact, state.normal));
    const glm::dvec3 held = contact + guideSpring_.force(guides.pull, guides.across, hand.rests);
    const glm::dvec3 cuts =
        cuttingRendering_.render(cutting, {motion.way(), state.proxyVelocity, state.normal, load, period});
    const glm::dvec3 room = besideHeld(held, cuts, limiter_.maximum());
    cuttingGaveWay_ = room != cuts;
    return held + room;
}

bool ForceOutput::quiet() const noexcept {
    constexpr double felt = 0.02; // N: the smallest force that a desktop device can render and a hand notices
    return glm::length(rendered_) < felt;
}

void ForceOutput::none(bool fadesIn, Sample& sample) noexcept {
    sample.force = sample.torque = glm::dvec3(0.0);
    sample.flags |= sampleForcesOff;
    if (relief_.active()) sample.flags |= sampleMotorsHot;
    fadesIn ? fadeIn() : nothingSent();
}

void ForceOutput::nothingSent() noexcept {
    wrench_ = {};
    wrench_.assist = assist_.none();
    rendered_ = lifted_ = glm::dvec3(0.0);
    turnCoupling_.reset();
    limiter_.reset();
    passivity_.reset();
    handPlace_.reset();
}

void ForceOutput::fadeIn() noexcept {
    nothingSent();
    ramp_.restart();
    cuttingRendering_.reset();
    toolMotion_.reset();
}

} // namespace burin
