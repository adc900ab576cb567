// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/force/motion_estimator.h"
#include "core/haptics/force/passivity_controller.h"
#include "core/haptics/haptic_settings.h"

#include <optional>

namespace burin {

/// The spring that turns the hand's axis to the tool's, where the device renders torque. Its stiffness follows the
/// device's figure as the coupling's does; the torque keeps its direction where it is limited, and changes by no more
/// in a tick than a turn at 5 rad/s lets it. No device states a damper for turns: there is none but the energy
/// controller's, which is bounded by what the sampled spring loses. Device frame.
class TurnCoupling {
public:
    explicit TurnCoupling(const HapticSettings& settings) noexcept;

    /// @param turnBehind rad, rotation vector from the hand's axis to the tool's. @param hand its rotation
    /// @param period s @return N·mm: turns the hand; to be told to `sent`
    glm::dvec3 torque(const glm::dvec3& turnBehind, const glm::dquat& hand, double period) noexcept;
    /// What really went to the device until the next tick, N·mm.
    void sent(const glm::dvec3& torque) noexcept { passivity_.sent(torque); }
    /// As before the first tick; `setShare` stays.
    void reset() noexcept;
    /// @param share of the maximum that the device may be asked for, 0 … 1
    void setShare(double share) noexcept { share_ = share; }

    double stiffness() const noexcept { return stiffness_; }      ///< N·mm/rad; 0 without motors for it
    double maximum() const noexcept { return share_ * maximum_; } ///< N·mm

private:
    PassivityController::Motion motionOf(const glm::dquat& hand, double period) noexcept;

    double stiffness_, maximum_;
    double slew_; ///< N·mm a tick
    PassivityController passivity_;
    MotionEstimator turning_;
    std::optional<glm::dquat> hand_; ///< in the last tick
    glm::dvec3 angle_{0.0};          ///< rad, sum of its turns
    double share_ = 1.0;
    glm::dvec3 last_{0.0};
};

} // namespace burin
