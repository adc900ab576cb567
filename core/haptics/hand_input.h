// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_settings.h"
#include "core/haptics/motion_estimator.h"
#include "core/haptics/reading_guard.h"

namespace burin {

/// The hand, as one tick sees it.
struct Hand {
    Reading reading = Reading::fault;
    Pose device;                    ///< device frame; of the last reading that had one
    glm::dvec3 deviceVelocity{0.0}; ///< mm/s, device frame
    ToolPose wanted;                ///< setup frame: where the hand wants the tool
    glm::dvec3 velocity{0.0};       ///< mm/s, setup frame, of the tip that is wanted
    bool rests = false;             ///< what moves is mostly the encoders
    std::uint32_t buttons = 0;      ///< 0 with a fault
};

/// From what a stylus read to where the hand wants the tool: judges the reading, maps it, measures its speed.
/// Tick code.
class HandInput {
public:
    explicit HandInput(const HapticSettings& settings) noexcept;

    /// @param period s since the tick before
    Hand operator()(const StylusState& state, double period) noexcept;
    /// The speed is measured anew: nobody knows where the hand has been meanwhile.
    void forget() noexcept { motion_.reset(); }
    const WorkspaceMapping& mapping() const noexcept { return mapping_; }

private:
    WorkspaceMapping mapping_;
    ReadingGuard guard_;
    MotionEstimator motion_;
    double averaging_; ///< share of the reading before, at rest
};

} // namespace burin
