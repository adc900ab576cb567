// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/cutting/removal.h"
#include "core/device/stylus.h"
#include "core/haptics/proxy.h"
#include "core/recording/sample.h"

namespace burin {

/// From the device frame to the setup frame: tip = origin + scale · (rotation · device position).
struct WorkspaceMapping {
    glm::dvec3 origin{0.0};                                ///< mm, setup frame: where the device's zero lies
    glm::dquat rotation = glm::dquat(1.0, 0.0, 0.0, 0.0);
    double scale = 1.0;                                    ///< mm of setup per mm of device, > 0

    glm::dvec3 toSetup(const glm::dvec3& device) const noexcept { return origin + rotation * device * scale; }
    glm::dvec3 toDevice(const glm::dvec3& setup) const noexcept {
        return glm::conjugate(rotation) * (setup - origin) / scale;
    }
};

/// Gains and limits of one session.
struct HapticSettings {
    WorkspaceMapping mapping;
    StylusDescription stylus;          ///< whose limits bound everything that is sent
    double allowance = 0.0;            ///< mm left on the part
    double cuttingSpeed = 1000.0;      ///< mm/s of the flutes' edge
    double cuttingForceScale = 0.01;   ///< rendered / real cutting force
    double couplingShare = 0.8;        ///< of the stylus' maximum stiffness
    double forceShare = 0.6;           ///< of the stylus' maximum force
    double rampSeconds = 1.5;          ///< forces fade in after start and after any fault
};

/// One tick of milling: mapping, proxy, swept cut, force, coupling, limits (design.md section 4). A function of its
/// inputs and its state: no clock, no allocation, lock, exception, log or file.
/// Thread: the one writer of the workpiece.
class HapticStep {
public:
    /// All references must outlive the object.
    HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool, const HapticSettings& settings);

    /// @param state what the stylus read; @param period s since the tick before, > 0.
    /// @return the tick's record; `Sample::force` is what goes to the device, in the device frame via `deviceForce`.
    Sample operator()(const StylusState& state, double period) noexcept;

    /// Force of the last tick in the device frame, N.
    glm::dvec3 deviceForce() const noexcept { return deviceForce_; }
    /// True once the tool has been clear of the part; forces stay off until then.
    bool started() const noexcept { return started_; }
    void setAllowance(double allowance) noexcept;

private:
    RunVolume* workpiece_;
    glm::dvec3 deviceForce_{0.0};
    bool started_ = false;
};

} // namespace burin
