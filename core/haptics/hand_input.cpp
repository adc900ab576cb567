// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/hand_input.h"

#include "core/haptics/force/coupling.h"

#include <algorithm>

namespace burin {
namespace {

/// Loss of the handle's damping that averaging may cause, N·s/m: less than the damping of the lightest grip.
constexpr double averagingLoss = 0.8;

/// Averaging two readings halves the step of the coupling force when the encoders of a resting hand tick. It delays
/// them by this share of a tick, which for a spring K means a loss of K T.
double averagingShare(const HapticSettings& settings) noexcept {
    const double stiffness = boundaryGains(settings).stiffness;
    const double loss = stiffness * settings.tickPeriod; // N·s/m, for a whole tick
    return loss > 0.0 ? std::min(0.5, averagingLoss / loss) : 0.0;
}

} // namespace

HandInput::HandInput(const HapticSettings& settings) noexcept
    : workspace_(settings)
    , guard_(settings.stylus, settings.tickPeriod)
    , motion_(settings.stylus.positionStep.value)
    , averaging_(averagingShare(settings)) {}

Hand HandInput::read(const StylusState& state, double period, const glm::dvec3* tool, bool quiet) noexcept {
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
    motion_.add(state.pose.position, period);
    hand.rests = motion_.rests();
    hand.deviceVelocity = motion_.velocity();
    const Pose pose{hand.rests ? motion_.averaged(averaging_) : hand.device.position, hand.device.rotation};
    const Workspace::Place place = workspace_.map(pose, state.buttons, tool, quiet, period);
    hand.wanted = place.wanted;
    hand.mapping = place.mapping;
    hand.clutched = workspace_.clutched();
    hand.velocity = place.drive;
    if (place.follows) hand.velocity += place.mapping.scale * place.mapping.directionToSetup(hand.deviceVelocity);
    return hand;
}

void HandInput::forget() noexcept {
    motion_.reset();
    workspace_.forget();
}

} // namespace burin
