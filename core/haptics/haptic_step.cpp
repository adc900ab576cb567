// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/haptic_step.h"

#include "core/haptics/boundary/fixed_axis_boundary.h"

#include <cmath>
#include <memory>
#include <utility>

namespace burin {

HapticStep::HapticStep(RunVolume& workpiece, const ClearanceField& field, const Tool& tool,
                       const HapticSettings& settings)
    : HapticStep(workpiece, BoundaryLayers(std::make_unique<FixedAxisBoundary>(field)), tool, settings) {}

HapticStep::HapticStep(RunVolume& workpiece, BoundaryLayers layers, const Tool& tool, const HapticSettings& settings)
    : HapticStep(workpiece, std::move(layers), tool, settings, columnsOf(tool.cutter, workpiece.grid())) {}

HapticStep::HapticStep(RunVolume& workpiece, BoundaryLayers layers, const Tool& tool, const HapticSettings& settings,
                       const std::shared_ptr<const SolidColumns>& columns)
    : input_(settings)
    , layers_(std::move(layers))
    , part_(layers_.part())
    , guides_(part_, settings)
    , mover_(layers_, tool, workpiece, settings, columns)
    , cut_(workpiece, tool, settings, columns)
    , output_(settings) {}

Sample HapticStep::advance(const StylusState& state, double period) noexcept {
    Sample sample = beginSample(period);
    heldBy_ = 0;
    const Hand hand = input_.read(state, period, started_ ? &mover_.pose().tip : nullptr, output_.quiet());
    sample.device = hand.device;
    sample.stylusTip = hand.wanted.tip;
    sample.proxy = shown_ = started_ ? mover_.pose() : mover_.parkedAbove(hand.wanted);
    if (cut_.memoryFull()) sample.flags |= sampleMemoryFull;
    if (hand.reading != Reading::fault) cut_.button((hand.buttons & 1u) != 0);
    if (!cut_.spindleTurns()) sample.flags |= sampleSpindleOff;
    if (hand.reading == Reading::fault) {
        sample.flags |= sampleStylusInvalid;
        input_.forget();
        guides_.forget();
        output_.none(true, sample);
        return sample;
    }
    sample.buttons = hand.buttons;
    if (!started_ && !start(hand.wanted)) {
        input_.forget();
        output_.none(true, sample);
        return sample;
    }
    part_.setAxis(mover_.pose().axis);
    const GuidedHand guided = guides_.guide(hand, mover_.pose(), cut_.spindleTurns(), period);
    if (guided.held != 0) sample.flags |= sampleOnGuide;
    mover_.setScale(hand.mapping.scale);
    ToolMotion motion = mover_.move(guided.goal, period, cut_);
    const CuttingForce cutting = cut_.cut(motion, period, sample);
    mover_.arrive(motion);
    sample.proxy = shown_ = mover_.pose();
    if (motion.shankContact) sample.flags |= sampleShankContact;
    noteHold(motion, sample);
    if (motion.axisHeld) sample.flags |= sampleAxisHeld;
    output_.motorsAre(state.motorHeat, period);
    output_.render(motion, cutting, hand, guided, period, sample);
    return sample;
}

/// A trace recorder has room for this many changes per tick while it waits for the disk.
void HapticStep::takeTiles() noexcept {
    constexpr int most = 2;
    for (int i = 0; i < most; ++i) {
        const std::optional<TileChange> change = layers_.part().nextChange(shown_);
        if (!change) return;
        changeTile(*change);
    }
}

void HapticStep::listen(StepChangeListener* listener) noexcept {
    listener_ = listener;
    tell(SpindleRelease{cut_.spindleReleased()});
}

void HapticStep::apply(const StepChange& change) noexcept {
    struct Apply {
        HapticStep& step;
        void operator()(const AllowanceChange& told) const noexcept { step.setAllowance(told.allowance); }
        void operator()(const GuideSettings& told) const noexcept { step.setGuides(told); }
        void operator()(const LevelStep& told) const noexcept { step.stepGuides(told.levels); }
        void operator()(const WorkspaceSettings& told) const noexcept { step.setWorkspace(told); }
        void operator()(const LayerSwitch& told) const noexcept { step.switchLayer(told.layer, told.on); }
        void operator()(const SpindleRelease& told) const noexcept { step.releaseSpindle(told.released); }
        void operator()(const TakeBegin& told) const noexcept {
            step.tell(told);
            step.cut_.skipOne();
        }
        void operator()(const ForceWithheld&) const noexcept { step.forceWithheld(); }
        void operator()(const CutResumption&) const noexcept { step.resumeCutting(); }
        void operator()(const WorkpieceChange& told) const noexcept { step.workpieceChanged(told); }
        void operator()(const TileChange& told) const noexcept { step.changeTile(told); }
    };
    std::visit(Apply{*this}, change);
}

Sample HapticStep::beginSample(double period) noexcept {
    Sample sample;
    if (tick_ > 0 && std::isfinite(period) && period > 0.0) time_ += period;
    sample.tick = tick_++;
    sample.time = time_;
    return sample;
}

void HapticStep::noteHold(const ToolMotion& motion, Sample& sample) noexcept {
    if (motion.normal == glm::dvec3(0.0)) return;
    sample.flags |= sampleOnBoundary;
    constexpr std::uint64_t part = 1;
    heldBy_ = layers_.partAlone() ? part : layers_.touching(mover_.pose(), Proxy::contactGap);
    if ((heldBy_ & ~part) != 0) sample.flags |= sampleOnObstacle;
}

bool HapticStep::start(const ToolPose& hand) noexcept {
    if (!mover_.start(hand, cut_)) return false;
    cut_.takeUp();
    output_.toolTakenUp();
    started_ = true;
    return true;
}

void HapticStep::beginTake() noexcept {
    tell(TakeBegin{});
    tick_ = 0;
    time_ = 0.0;
    cut_.skipOne();
}

void HapticStep::workpieceChanged(const WorkpieceChange& change) noexcept {
    tell(change);
    cut_.workpieceChanged();
    mover_.workpieceChanged();
    input_.forget();
    guides_.forget();
    output_.fadeIn();
}

} // namespace burin
