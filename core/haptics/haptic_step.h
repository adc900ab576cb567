// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/haptics/boundary/part_at_axis.h"
#include "core/haptics/cut_tick.h"
#include "core/haptics/force/force_output.h"
#include "core/haptics/guides/guide_set.h"
#include "core/haptics/hand_input.h"
#include "core/haptics/step_change.h"
#include "core/haptics/tool_mover.h"

namespace burin {

/// One tick of milling: hand, tool, cut, force (core/README.md). A function of its inputs and its state: no clock,
/// no allocation, lock, exception, log or file.
/// Thread: the one writer of the workpiece.
class HapticStep {
public:
    /// The workpiece must outlive the object; the tool is copied.
    /// @param layers what bounds the tool; made for the axis mode of the settings
    HapticStep(RunVolume& workpiece, BoundaryLayers layers, const Tool& tool, const HapticSettings& settings);
    /// The part alone, as a field for the axis of the settings. It must outlive the object.
    HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool, const HapticSettings& settings);
    HapticStep(const HapticStep&) = delete;
    HapticStep& operator=(const HapticStep&) = delete;

    /// @param state what the stylus read; @param period s since the tick before, > 0.
    /// @return the tick's record; what goes to the device is `deviceWrench`.
    /// Until `started`, the record's proxy is parked clear above the hand, and nothing is cut. Neither is anything in
    /// the first tick of a take: the tool is taken up where it stands, so that what is cut lies between two samples.
    /// While the spindle stands (sampleSpindleOff) the part alone holds the tool; stock, shank and holder don't count.
    Sample advance(const StylusState& state, double period) noexcept;

    /// What the last tick leaves to the device, device frame.
    const Wrench& deviceWrench() const noexcept { return output_.wrench(); }
    /// True once the tool has been clear of the part; forces stay off until then.
    bool started() const noexcept { return started_; }
    /// Takes effect over some ticks (5 mm/s), without a kick. @param allowance mm, >= 0
    void setAllowance(double allowance) noexcept {
        tell(AllowanceChange{allowance});
        mover_.setAllowance(allowance);
    }
    /// Guides for the hand; they fade in and out. Between two ticks. Their curves outlive the step.
    void setGuides(const GuideSettings& guides) noexcept {
        tell(guides);
        guides_.set(guides);
    }
    /// See GuideSet::step.
    void stepGuides(int levels) noexcept {
        tell(LevelStep{levels});
        guides_.step(levels);
    }
    const GuideSet& guides() const noexcept { return guides_; }
    /// Scale, turn, clutch, recentring: see Workspace. Between two ticks.
    void setWorkspace(const WorkspaceSettings& workspace) noexcept {
        tell(workspace);
        input_.setWorkspace(workspace);
    }
    const Workspace& workspace() const noexcept { return input_.workspace(); }
    /// Takes effect with the next tick, without a kick: a layer that the tool is inside of waits until it is clear.
    /// @param layer its number in the layers that the step was made with
    void switchLayer(std::size_t layer, bool on) noexcept {
        tell(LayerSwitch{layer, on});
        layers_.switchTo(layer, on);
    }
    /// What has come of a part's boundary that grows is in force from the next tick on: a little at a time. Between two
    /// ticks.
    void takeTiles() noexcept;
    const BoundaryLayers& layers() const noexcept { return layers_; }
    /// The layers that held the tool in the last tick, by bit of their number (BoundaryLayers::touching).
    std::uint64_t heldBy() const noexcept { return heldBy_; }
    /// Writes what was cut to the workpiece, which lags by up to 16 ticks. For whoever reads it for good: before a
    /// snapshot that is to be restored, undo, saving, amounts; pictures need not. Loop's thread, between two ticks.
    void settle() noexcept { cut_.settle(); }
    /// Cuts again after the reserved memory had run out and the owner has made room.
    void resumeCutting() noexcept {
        tell(CutResumption{});
        cut_.resume();
    }
    /// Ticks and time of the samples start again from 0 with the next tick.
    void beginTake() noexcept;
    /// @param released false: the spindle stands, whatever the button says. A new step's is released.
    void releaseSpindle(bool released) noexcept {
        tell(SpindleRelease{released});
        cut_.releaseSpindle(released);
    }
    /// The last tick's force came too late and was not sent: the next one rises from nothing, as fast as forces may.
    void forceWithheld() noexcept {
        tell(ForceWithheld{});
        output_.nothingSent();
    }
    /// The owner put another state of the workpiece in place, between two ticks: what the step knew of it is forgotten,
    /// and forces fade in again.
    void workpieceChanged() noexcept;
    /// Who hears, from now on, what the step is told; first whether its spindle is released. It outlives the step, or
    /// nullptr comes before its end. Between two ticks.
    void listen(StepChangeListener* listener) noexcept;
    /// As one of the functions above. A take begins without the samples' numbers and time: they count on.
    void apply(const StepChange& change) noexcept;
    /// What shank or holder touched in the last tick; meaningful with sampleShankContact.
    const ShankContact& shankContact() const noexcept { return mover_.shankContact(); }

    /// What the flutes stand in after the last tick.
    MetMaterial met() const noexcept { return cut_.met(); }

    /// What the limits were made from, for meters and tests.
    double couplingStiffness() const noexcept { return output_.couplingStiffness(); } ///< N/m, device space
    const ForceLimiter& limiter() const noexcept { return output_.limiter(); }

private:
    template <class Change>
    void tell(const Change& change) noexcept {
        if (listener_ != nullptr) listener_->changed(StepChange(change));
    }
    Sample beginSample(double period) noexcept;
    bool start(const ToolPose& hand) noexcept;
    void changeTile(const TileChange& change) noexcept {
        tell(change);
        layers_.part().apply(change);
    }
    void noteHold(const ToolMotion& motion, Sample& sample) noexcept;

    HandInput input_;
    BoundaryLayers layers_;
    PartAtAxis part_;
    GuideSet guides_;
    ToolMover mover_;
    CutTick cut_;
    ForceOutput output_;

    StepChangeListener* listener_ = nullptr;
    std::uint64_t tick_ = 0, heldBy_ = 0;
    double time_ = 0.0;
    bool started_ = false;
    ToolPose shown_; ///< of the last sample
};

} // namespace burin
