// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/hand_input.h"

namespace burin {

HandInput::HandInput(const HapticSettings& settings) noexcept
    : workspace_(settings), guard_(settings.stylus, settings.tickPeriod) {}

Hand HandInput::operator()(const StylusState& state, double period, const glm::dvec3* tool, bool quiet) noexcept {
    Hand hand;
    hand.reading = guard_.check(state, period);
    hand.device = guard_.lastPose();
    if (hand.reading == Reading::fault) {
        const WorkspaceMapping& mapping = hand.mapping = workspace_.mapping();
        hand.wanted = {mapping.toSetup(hand.device.position),
                       mapping.directionToSetup(hand.device.rotation * glm::dvec3(0.0, 0.0, 1.0))};
        return hand;
    }
    hand.buttons = state.buttons;
    const Workspace::Place place = workspace_(hand.device, state.buttons, tool, quiet, period);
    hand.wanted = place.wanted;
    hand.mapping = place.mapping;
    hand.clutched = workspace_.clutched();
    velocity_.add(state.pose.position, period);
    hand.deviceVelocity = velocity_.velocity();
    hand.velocity = place.drive;
    if (place.follows) hand.velocity += place.mapping.scale * place.mapping.directionToSetup(hand.deviceVelocity);
    return hand;
}

void HandInput::forget() noexcept {
    velocity_.reset();
    workspace_.forget();
}

} // namespace burin
