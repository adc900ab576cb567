// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/haptics/force/assist_output.h"
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

/// From the positions of hand and tool to the wrench of the device: coupling, cutting force, energy, limits, fading in.
/// Called in the haptic tick.
class ForceOutput {
public:
    explicit ForceOutput(const HapticSettings& settings) noexcept;

    /// Computes one tick's force and stores it in the sample and in `wrench`.
    void render(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand, const GuidedHand& guided,
                double period, Sample& sample) noexcept;
    /// Takes the heat reported by the motors, before a tick's force: hot motors get a lower maximum (HeatRelief).
    void motorsAre(double heat, double period) noexcept;
    /// No force in this tick. @param fadesIn whether the following forces fade in from zero
    void none(bool fadesIn, Sample& sample) noexcept;
    /// The last tick's force was not sent, so that the device renders none. Forces rise again from zero, without fading
    /// in.
    void nothingSent() noexcept;
    /// Lets forces fade in from zero.
    void fadeIn() noexcept;
    /// The tool was loaded at another position; the jump there is not a motion.
    void toolTakenUp() noexcept { toolMotion_.reset(); }

    /// Whether the hand felt nothing in the last tick.
    bool quiet() const noexcept;
    /// The wrench of the last tick, device frame. If the handle has to be carried and the device does not do so itself,
    /// it includes the force that carries the handle: constant, within the maximum, fading in and switched off together
    /// with the other forces.
    const Wrench& wrench() const noexcept { return wrench_; }
    double couplingStiffness() const noexcept { return coupling_.stiffness(); } ///< N/m, device space
    const ForceLimiter& limiter() const noexcept { return limiter_; }

private:
    glm::dvec3 wanted(const ToolMotion& motion, const CuttingForce& cutting, const Hand& hand, const GuidedHand& guided,
                      double period) noexcept;
    PassivityController::Motion motionOf(const Hand& hand) noexcept;

    AssistOutput assist_;
    Coupling coupling_, guideSpring_;
    TurnCoupling turnCoupling_;
    CuttingForceRendering cuttingRendering_;
    PassivityController passivity_;
    double maximum_;         ///< N, maximum that is ever sent
    double weight_;          ///< N, weight of the handle that the motors have to lift
    glm::dvec3 lift_;        ///< N, device frame, compensates the handle's weight
    glm::dvec3 lifted_{0.0}; ///< N, the part of the lift that is sent: after a gap it comes back in steps
    HeatRelief relief_;
    ForceLimiter limiter_;
    ForceRamp ramp_;
    MotionEstimator toolMotion_;
    std::uint32_t forceButtons_;
    Wrench wrench_;
    std::optional<glm::dvec3> handPlace_; ///< mm, device frame, position in the last tick with a force
    glm::dvec3 rendered_{0.0};            ///< N, device frame: force of the wrench without the lift
    /// whether in the last tick the cutting force was reduced in favour of the force that holds the tool
    bool cuttingGaveWay_ = false;
};

} // namespace burin
