// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/simulated_handle.h"

namespace burin::benchmarks {

/// A device held in a hand above the floor of a part, without stock, on which all contact figures are measured. The
/// coupling has exactly the given stiffness, whatever the device's values would imply.
class HeldFloor {
public:
    struct Device {
        double stiffness = 400.0; ///< N/m, of the coupling
        double damping = 4.0;     ///< N·s/m, value of the device
        double force = 100.0;     ///< N, value of the device: large, so that no clamp hides the behaviour of the loop
        double scale = 1.0;       ///< mm of setup per mm of device
    };

    HeldFloor(const Device& device, const test::SimulatedGrip& grip, const test::SimulatedMechanism& mechanism,
              double startHeight);

    /// Runs one tick of device and loop. @param intent  mm above the floor (device frame); @param push  N, positive
    /// downwards
    Sample tick(double intent, double push = 0.0);

    const test::SimulatedHandle& handle() const noexcept { return handle_; }
    const test::Rig& milling() const noexcept { return rig_; }
    double force() const noexcept { return rig_.step.deviceWrench().force.z; } ///< N, up
    double height() const noexcept; ///< mm, device frame: of the handle above the floor, as it is read

private:
    static HapticSettings settingsFor(const Device& device, const test::SimulatedMechanism& mechanism);
    double floor_; ///< mm, device frame
    test::Rig rig_;
    test::SimulatedHandle handle_;
};

} // namespace burin::benchmarks
