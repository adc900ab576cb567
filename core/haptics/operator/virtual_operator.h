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

/// The device that a virtual operator holds unless told otherwise: figures of a 3D Systems Touch in the device table of
/// CHAI3D (stated there for a closed loop at 1 kHz).
StylusDescription touchLikeStylus();

/// A mapping without rotation that lays a region of the setup into a device's workspace, with a tenth of the radius to
/// spare for what forces do to the hand. Small regions are magnified at most four times, so that slow work stays
/// within the speeds of a hand.
/// @param setupRegion mm, setup frame, not empty.
WorkspaceMapping mappingFor(const Box& setupRegion, const StylusDescription& stylus);

/// What a virtual operator is like.
struct OperatorSettings {
    StylusDescription stylus = touchLikeStylus();
    HandImpedance hand = firmHand;
    HandleInertia handle;
    HandReaction reaction;
    MotionLimits motion{.maximumSpeed = 500.0};  ///< device frame: mm of the device; half of what counts as a fault
    double integrationStep = HandArm::usualStep; ///< s, of hand and handle
    double encoderStep = 0.02;                   ///< mm, device frame; 0: exact
    double tremor = 0.05;                        ///< mm rms along each axis, device frame; 0: a calm hand
    std::uint64_t seed = 1;                      ///< of the tremor
};

/// A stylus held by a simulated hand that follows an intent. It reads back what a device would: the hand's place,
/// pushed away by the forces written to it, to the step of the encoders. The same intent, settings, times and forces
/// give the same readings, bit by bit.
class VirtualOperator final : public Stylus {
public:
    /// @param intent tips in the setup frame; @param mapping device to setup, as the haptic step has it.
    VirtualOperator(std::vector<IntentPoint> intent, const WorkspaceMapping& mapping, const OperatorSettings& settings);

    StylusDescription description() const override { return settings_.stylus; }
    /// Prepares the motion; again: starts anew. Errors: argumentInvalid (the intent, or a point of it beyond the
    /// workspace).
    Result<void> open() override;
    /// The motion starts with the first reading.
    StylusState read(double time) noexcept override;
    /// Held until the next write; what exceeds the device's force is cut off; not finite: zero.
    void write(const Wrench& wrench) noexcept override;
    /// The intent's end is reached and the hand has come to rest (or fails to for a second).
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
