// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/cutting/removal.h"
#include "core/haptics/engaged_area.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/met_material.h"
#include "core/haptics/tool_motion.h"
#include "core/recording/sample.h"

namespace burin {

/// The spindle and what it takes away in a tick. Tick code; the one writer of the workpiece.
class CutTick {
public:
    /// @param workpiece outlives the object
    CutTick(RunVolume& workpiece, const Tool& tool, const HapticSettings& settings);

    bool spindleTurns() const noexcept { return released_ && (!onButton_ || buttonDown_); }
    /// @param released false: the spindle stands, whatever the button says
    void releaseSpindle(bool released) noexcept { released_ = released; }
    bool spindleReleased() const noexcept { return released_; }
    void button(bool down) noexcept { buttonDown_ = down; }
    /// The tool is taken up where it stands: nothing is cut on the way there.
    void takeUp() noexcept;
    /// As `takeUp`, though the tool has been moving: the next tick does not cut.
    void skipOne() noexcept { takesUp_ = true; }

    /// Cuts what the flutes swept, and says what was removed: the paper's force of this very tick; area and mix of
    /// materials as they are felt, the area smoothed (EngagedArea), the mix that of the last tick that removed
    /// anything. A motion that ran out of memory is taken back, as part of its way is uncut.
    CuttingForce cut(ToolMotion& motion, double period, Sample& sample) noexcept;

    /// Writes what was cut to the workpiece. Nothing is ever put off between two ticks, so that there is nothing to
    /// count.
    void settle() noexcept;
    bool memoryFull() const noexcept { return memoryFull_; }
    void resume() noexcept { memoryFull_ = false; }
    /// It changed otherwise than by `cut`, between two ticks.
    void workpieceChanged() noexcept;
    const RunVolume& workpiece() const noexcept { return *workpiece_; }
    /// What the flutes stand in after the last tick; its area fades where they meet nothing.
    MetMaterial met() const noexcept { return {engagement_, area_.value(), felt_.energy}; }
    /// What the workpiece is owed: gone, though it may show it still.
    const GapWindow* owed() const noexcept { return removal_.window(); }

private:
    CutResult take(const ToolPose& from, const ToolPose& to) noexcept;
    CuttingForce asFelt(const CuttingForce& force) noexcept;

    RunVolume* workpiece_;
    CuttingCoefficients coefficients_;
    MaterialRemoval removal_;
    SpinningTool tool_;
    EngagedArea area_;
    CuttingForce felt_;             ///< area and mix as they are felt
    Engagement engagement_;         ///< of the last tick that told it
    double travelSinceRemoval_ = 0; ///< mm
    bool onButton_;
    bool released_ = true, buttonDown_ = false;
    bool takesUp_ = true; ///< the next tick does not cut
    bool memoryFull_ = false;
};

} // namespace burin
