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

/// One tick of milling: hand, tool, cut, force (core/README.md). Depends only on its inputs and its state: no clock, no
/// allocation, lock, exception, log or file access.
/// Called on the haptic thread; the only writer of the workpiece.
class HapticStep {
public:
    /// The workpiece must outlive the object; the tool is copied.
    /// @param layers the boundaries of the tool; made for the axis mode of the settings
    HapticStep(RunVolume& workpiece, BoundaryLayers layers, const Tool& tool, const HapticSettings& settings);
    /// With the part as the only boundary, as a field for the axis of the settings. It must outlive the object.
    HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool, const HapticSettings& settings);
    HapticStep(const HapticStep&) = delete;
    HapticStep& operator=(const HapticStep&) = delete;

    /// @param state the reading of the stylus; @param period s since the last tick, > 0.
    /// @return the tick's record; the wrench for the device is `deviceWrench`.
    /// Until `started`, the record's proxy is parked clear above the hand, and nothing is cut. Nothing is cut in the
    /// first tick of a take either: the tool is loaded at its current pose, so that every cut lies between two samples.
    /// While the spindle is stopped (sampleSpindleOff) only the part holds the tool; stock, shank and holder are
    /// ignored.
    Sample advance(const StylusState& state, double period) noexcept;

    /// The wrench of the last tick for the device, device frame.
    const Wrench& deviceWrench() const noexcept { return output_.wrench(); }
    /// True once the tool has been clear of the part; forces stay off until then.
    bool started() const noexcept { return started_; }
    /// Takes effect gradually (5 mm/s), without a jump of the force. @param allowance mm, >= 0
    void setAllowance(double allowance) noexcept {
        tell(AllowanceChange{allowance});
        mover_.setAllowance(allowance);
    }
    /// Sets the guides for the hand; they fade in and out. Called between two ticks. Their curves must outlive the
    /// step.
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
    /// Scale, rotation, clutch, recentring: see Workspace. Called between two ticks.
    void setWorkspace(const WorkspaceSettings& workspace) noexcept {
        tell(workspace);
        input_.setWorkspace(workspace);
    }
    const Workspace& workspace() const noexcept { return input_.workspace(); }
    /// Takes effect with the next tick, without a jump of the force: a layer that contains the tool waits until the
    /// tool is clear of it.
    /// @param layer its number in the layers that were passed to the constructor
    void switchLayer(std::size_t layer, bool on) noexcept {
        tell(LayerSwitch{layer, on});
        layers_.switchTo(layer, on);
    }
    /// New tiles of a growing part boundary are in force from the next tick on, a few per call. Called between two
    /// ticks.
    void takeTiles() noexcept;
    const BoundaryLayers& layers() const noexcept { return layers_; }
    /// The layers that held the tool in the last tick, as a bit mask of their numbers (BoundaryLayers::touching).
    std::uint64_t heldBy() const noexcept { return heldBy_; }
    /// Writes pending cuts to the workpiece, which lags by up to 16 ticks. Required before uses that need the exact
    /// state: before a snapshot that is to be restored, undo, saving, amounts; not for display. Haptic thread, between
    /// two ticks.
    void settle() noexcept { cut_.settle(); }
    /// Cuts again after the reserved memory had run out and the owner has made room.
    void resumeCutting() noexcept {
        tell(CutResumption{});
        cut_.resume();
    }
    /// The tick numbers and times of the samples start again from 0 with the next tick.
    void beginTake() noexcept;
    /// @param released false: the spindle is stopped, whatever the state of the button. A new step is released.
    void releaseSpindle(bool released) noexcept {
        tell(SpindleRelease{released});
        cut_.releaseSpindle(released);
    }
    /// The last tick's force came too late and was not sent: the next one rises from zero, as fast as forces may.
    void forceWithheld() noexcept {
        tell(ForceWithheld{});
        output_.nothingSent();
    }
    /// The owner replaced the state of the workpiece, between two ticks: cached knowledge of the workpiece is dropped,
    /// and forces fade in again.
    void workpieceChanged(const WorkpieceChange& change) noexcept;
    /// Sets the listener to all further changes of the step; it is first called with whether the spindle is released.
    /// The listener outlives the step, or `listen(nullptr)` is called before its end. Called between two ticks.
    void listen(StepChangeListener* listener) noexcept;
    /// Applies a recorded change, like one of the functions above. A take begins without resetting the samples' numbers
    /// and time: they count on. For a WorkpieceChange the workpiece has to be in its new state already.
    void apply(const StepChange& change) noexcept;
    /// What shank or holder touched in the last tick; only valid with sampleShankContact.
    const ShankContact& shankContact() const noexcept { return mover_.shankContact(); }

    /// The material around the flutes after the last tick.
    MetMaterial met() const noexcept { return cut_.met(); }

    /// The quantities that the limits were derived from, for meters and tests.
    double couplingStiffness() const noexcept { return output_.couplingStiffness(); } ///< N/m, device space
    const ForceLimiter& limiter() const noexcept { return output_.limiter(); }

private:
    /// @param columns of the tool, which contact and cuts share; null: it has no solid
    HapticStep(RunVolume& workpiece, BoundaryLayers layers, const Tool& tool, const HapticSettings& settings,
               const std::shared_ptr<const SolidColumns>& columns);
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
    ToolPose shown_; ///< pose in the last sample
};

} // namespace burin
