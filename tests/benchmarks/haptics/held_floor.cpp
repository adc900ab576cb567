// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/held_floor.h"

namespace burin::benchmarks {

HapticSettings HeldFloor::settingsFor(const Device& device, const test::SimulatedMechanism& mechanism) {
    HapticSettings settings = test::Rig::settings();
    settings.mapping.scale = device.scale;
    const double delay = static_cast<double>(mechanism.delay); // ticks
    settings.stylus.delay.value = delay * settings.tickPeriod;
    // The loop lowers its stiffness according to the delay; this compensates for it, so that the stiffness is the
    // requested one.
    settings.stylus.maximumStiffness.value = device.stiffness * (1.0 + 2.0 * delay) / settings.couplingShare;
    settings.stylus.maximumDamping.value = device.damping;
    settings.stylus.maximumForce.value = device.force;
    settings.stylus.positionStep.value = mechanism.encoder;
    return settings;
}

HeldFloor::HeldFloor(const Device& device, const test::SimulatedGrip& grip, const test::SimulatedMechanism& mechanism,
                     double startHeight)
    : floor_(test::floorHeight / device.scale)
    , rig_(settingsFor(device, mechanism), test::ballTool(), test::stockOnPart(0, false))
    , handle_(grip, mechanism, {0.0, 0.0, floor_ + startHeight}) {
    rig_.begin(handle_.reading());
}

Sample HeldFloor::tick(double intent, double push) {
    const Sample sample = rig_.feed(handle_.reading());
    handle_.hold(rig_.step.deviceWrench().force, {0.0, 0.0, floor_ + intent}, {0.0, 0.0, -push}, test::period);
    return sample;
}

double HeldFloor::height() const noexcept {
    return handle_.reading().z - floor_;
}

} // namespace burin::benchmarks
