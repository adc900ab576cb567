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

/// The spindle and the material that it removes in a tick. Called in the haptic tick; the only writer of the workpiece.
class CutTick {
public:
    /// @param workpiece outlives the object @param columns of the tool on its grid; null: the tool has no solid
    CutTick(RunVolume& workpiece, const Tool& tool, const HapticSettings& settings,
            std::shared_ptr<const SolidColumns> columns);

    bool spindleTurns() const noexcept { return released_ && (!onButton_ || buttonDown_); }
    /// @param released false: the spindle is stopped, whatever the state of the button
    void releaseSpindle(bool released) noexcept { released_ = released; }
    bool spindleReleased() const noexcept { return released_; }
    void button(bool down) noexcept { buttonDown_ = down; }
    /// The tool is loaded at its current position: nothing is cut on the way there.
    void takeUp() noexcept;
    /// Like `takeUp`, but the tool has been moving: the next tick does not cut.
    void skipOne() noexcept { takesUp_ = true; }

    /// Cuts the material that the flutes swept, and returns what was removed: the force of this very tick according to
    /// the paper; area and mix of materials as they are felt, the area smoothed (EngagedArea), the mix that of the last
    /// tick that removed anything. A motion that ran out of memory is undone, because part of it remained uncut.
    CuttingForce cut(ToolMotion& motion, double period, Sample& sample) noexcept;

    /// Writes pending cuts to the workpiece. No counting of removed material is ever put off between two ticks, so that
    /// nothing remains to be counted here.
    void settle() noexcept;
    bool memoryFull() const noexcept { return memoryFull_; }
    void resume() noexcept { memoryFull_ = false; }
    /// Must be called after the workpiece was changed otherwise than by `cut`, between two ticks.
    void workpieceChanged() noexcept;
    const RunVolume& workpiece() const noexcept { return *workpiece_; }
    /// The material around the flutes after the last tick; its area fades out where they meet none.
    MetMaterial met() const noexcept { return {engagement_, area_.value(), felt_.energy}; }
    /// Pending cuts: material that is removed although the workpiece may still show it.
    const CutCache* owed() const noexcept { return removal_.window(); }

private:
    CutResult take(const ToolPose& from, const ToolPose& to) noexcept;
    CuttingForce asFelt(const CuttingForce& force) noexcept;

    RunVolume* workpiece_;
    CuttingCoefficients coefficients_;
    MaterialRemoval removal_;
    SpinningTool tool_;
    EngagedArea area_;
    CuttingForce felt_;             ///< area and mix of materials as they are felt
    Engagement engagement_;         ///< of the last tick that had an engagement
    double travelSinceRemoval_ = 0; ///< mm
    bool onButton_;
    bool released_ = true, buttonDown_ = false;
    bool takesUp_ = true; ///< the next tick does not cut
    bool memoryFull_ = false;
};

} // namespace burin
