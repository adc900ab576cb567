// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/haptics/force/coupling.h"
#include "core/haptics/force/cutting_force_rendering.h"
#include "core/haptics/force/force_limiter.h"
#include "core/haptics/force/heat_relief.h"
#include "core/haptics/force/motion_estimator.h"
#include "core/haptics/force/passivity_controller.h"
#include "core/haptics/force/turn_coupling.h"
#include "core/haptics/guides/guide_force.h"
#include "core/haptics/hand_input.h"
#include "core/haptics/tool_motion.h"
#include "core/recording/sample.h"

#include <optional>

namespace burin {

/// From where hand and tool are to what the device renders: coupling, cutting force, energy, limits, fading in.
/// Tick code.
class ForceOutput {
public:
    explicit ForceOutput(const HapticSettings& settings) noexcept;

    /// One tick's force, into the sample and `wrench`.
    void render(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand, const GuidedHand& guided,
                double period, Sample& sample) noexcept;
    /// What the motors say of themselves, before a tick's force: hot ones are asked for less (HeatRelief).
    void motorsAre(double heat, double period) noexcept;
    /// No force in this tick. @param fadesIn and the next ones begin from nothing
    void none(bool fadesIn, Sample& sample) noexcept;
    /// What the last tick rendered was not sent: the device holds nothing. Forces rise from there, without fading.
    void nothingSent() noexcept;
    /// Forces begin from nothing.
    void fadeIn() noexcept;
    /// The tool was taken up somewhere else: it did not move there.
    void toolTakenUp() noexcept { toolMotion_.reset(); }

    /// The hand felt nothing in the last tick.
    bool quiet() const noexcept;
    /// Of the last tick, device frame. Where the device has to carry its handle and does not do so itself, with the
    /// force that does: constant, within the maximum, fading in and gone with the other forces.
    const Wrench& wrench() const noexcept { return wrench_; }
    double couplingStiffness() const noexcept { return coupling_.stiffness(); } ///< N/m, device space
    const ForceLimiter& limiter() const noexcept { return limiter_; }

private:
    glm::dvec3 wanted(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand, const GuidedHand& guided,
                      double period) noexcept;
    PassivityController::Motion motionOf(const Hand& hand) noexcept;

    Coupling coupling_, guideSpring_;
    TurnCoupling turnCoupling_;
    CuttingForceRendering cuttingRendering_;
    PassivityController passivity_;
    double maximum_;         ///< N, that are ever sent
    double weight_;          ///< N, of the handle, that the motors have to lift
    glm::dvec3 lift_;        ///< N, device frame, against the handle's weight
    glm::dvec3 lifted_{0.0}; ///< N, that is sent of it: after a gap it comes back in steps
    HeatRelief relief_;
    ForceLimiter limiter_;
    ForceRamp ramp_;
    MotionEstimator toolMotion_;
    std::uint32_t forceButtons_;
    Wrench wrench_;
    std::optional<glm::dvec3> handPlace_; ///< mm, device frame, in the last tick with a force
    glm::dvec3 rendered_{0.0};            ///< N, device frame: the wrench's force without the lift
    bool cuttingGaveWay_ = false;         ///< in the last tick, to what holds the tool
};

} // namespace burin
