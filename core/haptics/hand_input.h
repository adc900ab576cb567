// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/force/motion_estimator.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/reading_guard.h"
#include "core/haptics/workspace.h"

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
    WorkspaceMapping mapping;       ///< in force in this tick: device to setup
    bool clutched = false;          ///< the hand moves on its own: it feels nothing
};

/// From what a stylus read to where the hand wants the tool: judges the reading, maps it, measures its speed.
/// Tick code.
class HandInput {
public:
    explicit HandInput(const HapticSettings& settings) noexcept;

    /// @param period s since the tick before. @param tool where the tool is, mm, setup frame; nullptr: none has been
    /// taken up. @param quiet the hand feels no force
    Hand read(const StylusState& state, double period, const glm::dvec3* tool, bool quiet) noexcept;
    /// The speed is measured anew: nobody knows where the hand has been meanwhile.
    void forget() noexcept;
    /// Between two ticks.
    void setWorkspace(const WorkspaceSettings& settings) noexcept { workspace_.set(settings); }
    const Workspace& workspace() const noexcept { return workspace_; }

private:
    Workspace workspace_;
    ReadingGuard guard_;
    MotionEstimator motion_;
    double averaging_; ///< share of the reading before, at rest
};

} // namespace burin
