// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/geometry/box.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/operator/operator_hand.h"
#include "core/passes/intent_motion.h"

#include <optional>
#include <vector>

namespace burin {

/// The default device of a virtual operator: values of a 3D Systems Touch from the device table of CHAI3D (stated there
/// for a closed loop at 1 kHz).
StylusDescription touchLikeStylus();

/// A mapping without rotation that fits a region of the setup into a device's workspace, with a tenth of the radius as
/// a margin for deviations caused by forces. Small regions are magnified at most four times, so that slow work stays
/// within the speeds of a hand.
/// @param setupRegion mm, setup frame, not empty.
WorkspaceMapping mappingFor(const Box& setupRegion, const StylusDescription& stylus);

/// Properties of a virtual operator.
struct OperatorSettings {
    StylusDescription stylus = touchLikeStylus();
    HandImpedance hand = firmHand;
    HandleInertia handle;
    HandReaction reaction;
    /// device frame: mm of the device; half of the speed that counts as a fault
    MotionLimits motion{.maximumSpeed = 500.0};
    double integrationStep = HandArm::usualStep; ///< s, for hand and handle
    double encoderStep = 0.02;                   ///< mm, device frame; 0: exact
    double tremor = 0.05;                        ///< mm rms along each axis, device frame; 0: a calm hand
    std::uint64_t seed = 1;                      ///< seed of the tremor
};

/// A stylus held by a simulated hand that follows an intended motion. It returns the readings of a real device: the
/// position of the hand, displaced by the forces written to it, with the resolution of the encoders. The same intent,
/// settings, times and forces give the same readings, bit by bit.
class VirtualOperator final : public Stylus {
public:
    /// @param intent tip positions in the setup frame; @param mapping device to setup, the same as in the haptic step.
    VirtualOperator(std::vector<IntentPoint> intent, const WorkspaceMapping& mapping, const OperatorSettings& settings);

    StylusDescription description() const override { return settings_.stylus; }
    /// Prepares the motion; a repeated call starts it again. Errors: argumentInvalid (the intent, or a point of it
    /// beyond the workspace).
    Result<void> open() override;
    /// Returns a reading. The motion starts with the first one.
    StylusState read(double time) noexcept override;
    /// The force is held until the next write. It is limited to the device's force; a force that is not finite counts
    /// as zero.
    void write(const Wrench& wrench) noexcept override;
    /// Whether the end of the intended motion is reached and the hand has come to rest (or failed to for a second).
    bool finished() const noexcept override;
    void close() noexcept override;

    double duration() const noexcept { return motion_ ? motion_->duration() : 0.0; } ///< s; 0 before open()

private:
    void stayInWorkspace(const glm::dvec3& intended) noexcept;

    std::vector<IntentPoint> intent_;
    WorkspaceMapping mapping_;
    OperatorSettings settings_;
    std::optional<IntentMotion> motion_; ///< device frame
    HandArm arm_;
    Tremor tremor_;
    glm::dvec3 force_{0.0};         ///< N
    std::optional<double> started_; ///< s, time of the first reading
    double time_ = 0.0;             ///< s, of the last reading
};

} // namespace burin
