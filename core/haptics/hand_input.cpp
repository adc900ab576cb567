// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/hand_input.h"

namespace burin {

HandInput::HandInput(const HapticSettings& settings) noexcept
    : mapping_(settings.mapping), guard_(settings.stylus, settings.tickPeriod) {}

Hand HandInput::operator()(const StylusState& state, double period) noexcept {
    Hand hand;
    hand.mapping = mapping_;
    hand.reading = guard_.check(state, period);
    hand.device = guard_.lastPose();
    hand.wanted = {mapping_.toSetup(hand.device.position),
                   mapping_.directionToSetup(hand.device.rotation * glm::dvec3(0.0, 0.0, 1.0))};
    if (hand.reading == Reading::fault) return hand;
    hand.buttons = state.buttons;
    velocity_.add(state.pose.position, period);
    hand.deviceVelocity = velocity_.velocity();
    hand.velocity = mapping_.scale * mapping_.directionToSetup(hand.deviceVelocity);
    return hand;
}

} // namespace burin
