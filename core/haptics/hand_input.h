// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/force/motion_estimator.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/reading_guard.h"
#include "core/haptics/workspace.h"

namespace burin {

/// The hand in one tick.
struct Hand {
    Reading reading = Reading::fault;
    Pose device;                    ///< device frame; of the last valid reading
    glm::dvec3 deviceVelocity{0.0}; ///< mm/s, device frame
    ToolPose wanted;                ///< setup frame: the pose that the hand requests for the tool
    glm::dvec3 velocity{0.0};       ///< mm/s, setup frame, of the requested tip
    bool rests = false;             ///< the motion consists mostly of encoder steps
    std::uint32_t buttons = 0;      ///< 0 in case of a fault
    WorkspaceMapping mapping;       ///< in force in this tick: device to setup
    bool clutched = false;          ///< the hand moves without the tool and feels no force
};

/// Converts readings of the stylus to the tool pose requested by the hand: checks the reading, maps it, measures its
/// speed.
/// Called in the haptic tick.
class HandInput {
public:
    explicit HandInput(const HapticSettings& settings) noexcept;

    /// @param period s since the last tick. @param tool position of the tool, mm, setup frame; nullptr: none is loaded.
    /// @param quiet whether the hand feels no force
    Hand read(const StylusState& state, double period, const glm::dvec3* tool, bool quiet) noexcept;
    /// Restarts the measurement of the speed, when the motion of the hand was not known for some time.
    void forget() noexcept;
    /// Called between two ticks.
    void setWorkspace(const WorkspaceSettings& settings) noexcept { workspace_.set(settings); }
    const Workspace& workspace() const noexcept { return workspace_; }

private:
    Workspace workspace_;
    ReadingGuard guard_;
    MotionEstimator motion_;
    double averaging_; ///< share of the previous reading in the mean, at rest
};

} // namespace burin
