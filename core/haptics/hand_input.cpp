// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/hand_input.h"

#include "core/haptics/coupling.h"

#include <algorithm>

namespace burin {
namespace {

/// N·s/m that averaging may take from the handle's damping: less than the lightest grip has.
constexpr double averagingLoss = 0.8;

/// Two readings averaged halve the step by which the coupling's force changes when a resting hand's encoders tick. They
/// come later by this share of a tick, which a spring K makes a loss of K T.
double averagingShare(const HapticSettings& settings) noexcept {
    const double stiffness = couplingGains(settings.stylus, settings.couplingShare, settings.tickPeriod).stiffness;
    const double loss = stiffness * settings.tickPeriod; // N·s/m, of a whole tick
    return loss > 0.0 ? std::min(0.5, averagingLoss / loss) : 0.0;
}

} // namespace

HandInput::HandInput(const HapticSettings& settings) noexcept
    : mapping_(settings.mapping)
    , guard_(settings.stylus, settings.tickPeriod)
    , motion_(settings.stylus.positionStep.value)
    , averaging_(averagingShare(settings)) {}

Hand HandInput::operator()(const StylusState& state, double period) noexcept {
    Hand hand;
    hand.reading = guard_.check(state, period);
    hand.device = guard_.lastPose();
    hand.wanted = {mapping_.toSetup(hand.device.position),
                   mapping_.directionToSetup(hand.device.rotation * glm::dvec3(0.0, 0.0, 1.0))};
    if (hand.reading == Reading::fault) return hand;
    hand.buttons = state.buttons;
    motion_.add(state.pose.position, period);
    hand.rests = motion_.rests();
    if (hand.rests) hand.wanted.tip = mapping_.toSetup(motion_.averaged(averaging_));
    hand.deviceVelocity = motion_.velocity();
    hand.velocity = mapping_.scale * mapping_.directionToSetup(hand.deviceVelocity);
    return hand;
}

} // namespace burin
