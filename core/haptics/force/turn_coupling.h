// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/force/motion_estimator.h"
#include "core/haptics/force/passivity_controller.h"
#include "core/haptics/haptic_settings.h"

#include <optional>

namespace burin {

/// The spring that turns the hand's axis to the tool's, on devices that render torque. Its stiffness follows from the
/// device's value in the same way as the coupling's. The torque keeps its direction when it is limited, and changes in
/// a tick by no more than a rotation at 5 rad/s causes. No device states a damping for rotations: the only damper is
/// that of the passivity controller, which is bounded by the loss of the sampled spring. Device frame.
class TurnCoupling {
public:
    explicit TurnCoupling(const HapticSettings& settings) noexcept;

    /// @param turnBehind rad, rotation vector from the hand's axis to the tool's. @param hand rotation of the hand
    /// @param period s @return torque on the hand, N·mm; the torque really sent has to be passed to `sent`
    glm::dvec3 torque(const glm::dvec3& turnBehind, const glm::dquat& hand, double period) noexcept;
    /// The torque that was really sent to the device until the next tick, N·mm.
    void sent(const glm::dvec3& torque) noexcept { passivity_.sent(torque); }
    /// Returns to the state before the first tick; `setShare` is kept.
    void reset() noexcept;
    /// @param share share of the maximum torque that may be used, 0 … 1
    void setShare(double share) noexcept { share_ = share; }

    double stiffness() const noexcept { return stiffness_; } ///< N·mm/rad; 0 if the device has no motors for torque
    double maximum() const noexcept { return share_ * maximum_; } ///< N·mm

private:
    PassivityController::Motion motionOf(const glm::dquat& hand, double period) noexcept;

    double stiffness_, maximum_;
    double slew_; ///< N·mm per tick
    PassivityController passivity_;
    MotionEstimator turning_;
    std::optional<glm::dquat> hand_; ///< in the last tick
    glm::dvec3 angle_{0.0};          ///< rad, sum of the hand's rotations
    double share_ = 1.0;
    glm::dvec3 last_{0.0};
};

} // namespace burin
