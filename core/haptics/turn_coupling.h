// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_settings.h"

namespace burin {

/// The spring that turns the hand's axis to the tool's, where the device renders torque. Its stiffness follows the
/// device's figure as the coupling's does; the torque keeps its direction where it is limited, and changes by no more
/// in a tick than a turn at 5 rad/s lets it. No damper: no device states one for turns.
class TurnCoupling {
public:
    explicit TurnCoupling(const HapticSettings& settings) noexcept;

    /// @param turnBehind ToolMotion's, rad @return N·mm, setup frame: turns the hand
    glm::dvec3 torque(const glm::dvec3& turnBehind) noexcept;
    void reset() noexcept { last_ = glm::dvec3(0.0); }
    /// @param share of the maximum that the device may be asked for, 0 … 1
    void setShare(double share) noexcept { share_ = share; }

    double stiffness() const noexcept { return stiffness_; }      ///< N·mm/rad; 0 without motors for it
    double maximum() const noexcept { return share_ * maximum_; } ///< N·mm

private:
    double stiffness_, maximum_;
    double slew_; ///< N·mm a tick
    double share_ = 1.0;
    glm::dvec3 last_{0.0};
};

} // namespace burin
