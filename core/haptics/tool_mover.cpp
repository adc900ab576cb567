// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/tool_mover.h"

#include "core/haptics/boundary/pose_vector.h"
#include "core/haptics/loop/tick_fault.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace burin {
namespace {

constexpr double voxelsPerTick = 6.0; // minimum travel
/// The same for a free axis: each query of the boundary is more expensive there, and a tool that was held and comes
/// free has time to catch up.
constexpr double voxelsPerTickFree = 2.0;
constexpr double voxelsOfRoom = 2.0; // by which the tip may make room for the axis in a tick
constexpr int parkingSamples = 256;

bool rendersTorque(const StylusDescription& stylus) noexcept {
    return stylus.actuated.rotations > 0 && stylus.maximumTurningStiffness.value > 0.0 &&
           stylus.maximumStiffness.value > 0.0;
}

/// Weights rotations relative to translations as the coupling's springs do, so that the tool rests where the energy of
/// these springs is minimal: where a weightless tool would rest that hangs on the hand by them.
/// @return mm, in a workspace of scale 1
double turnLength(const HapticSettings& settings) noexcept {
    if (!rendersTorque(settings.stylus)) return 1.0;
    const double newtonsPerMillimetre = settings.stylus.maximumStiffness.value * 1e-3;
    return std::sqrt(settings.stylus.maximumTurningStiffness.value / newtonsPerMillimetre);
}

/// Null: the settings ask for none.
StockBoundary* addStock(BoundaryLayers& layers, const Tool& tool, const RunVolume& workpiece, const StockLayer& stock) {
    if (!(stock.distance > 0.0)) return nullptr;
    auto boundary = std::make_unique<StockBoundary>(workpiece, tool.cutter, stock.distance);
    StockBoundary* const added = boundary.get();
    layers.add(std::move(boundary), stock.on);
    return added;
}

} // namespace

ToolMover::ToolMover(BoundaryLayers& layers, const Tool& tool, const RunVolume& workpiece,
                     const HapticSettings& settings, std::shared_ptr<const SolidColumns> columns)
    : layers_(layers)
    , stock_(addStock(layers, tool, workpiece, settings.stock))
    , axis_(settings.axis)
    , yields_(rendersTorque(settings.stylus) ? ProxyStride::Yields::both : ProxyStride::Yields::tip)
    , turnLengthAtScale1_(turnLength(settings))
    , room_(voxelsOfRoom * workpiece.grid().edge())
    , topOfWorkpiece_(workpiece.grid().box().high.z)
    , slowestTravel_((settings.axis.free ? voxelsPerTickFree : voxelsPerTick) * workpiece.grid().edge() /
                     settings.tickPeriod)
    , handSpeed_(settings.stylus.maximumSpeed.value)
    , longestPeriod_(gapLimits(settings.tickPeriod).late)
    , brake_(tool.cutter, workpiece.grid(), std::move(columns))
    , proxy_(layers)
    , allowance_(layers, settings.allowance) {
    setScale(settings.mapping.scale);
}

/// A tool that may be as fast as the fastest plausible hand follows the hand without a lag, hence without a force.
void ToolMover::setScale(double scale) noexcept {
    travelPerSecond_ = std::max(slowestTravel_, 1.1 * handSpeed_ * scale);
    turnLength_ = turnLengthAtScale1_ * scale;
}

ToolPose ToolMover::wanted(const ToolPose& hand) const noexcept {
    return {hand.tip, axis_.free ? hand.axis : axis_.direction};
}

ProxyStride ToolMover::stride(double period) const noexcept {
    const double time = std::min(period, longestPeriod_);
    ProxyStride stride;
    stride.travel = travelPerSecond_ * time;
    stride.turn = axis_.free ? turnSpeed * time : 0.0;
    stride.yields = yields_;
    stride.turnLength = turnLength_;
    stride.room = room_;
    return stride;
}

bool ToolMover::start(const ToolPose& hand, const CutTick& cut) noexcept {
    allowance_.settle();
    layers_.settle();
    if (stock_ != nullptr) stock_->beginTick(cut.owed(), cut.spindleTurns());
    const ToolPose pose = wanted(hand);
    if (!proxy_.feasible(pose)) return false;
    if (cut.spindleTurns() && brake_.at(cut.workpiece(), cut.owed(), pose).touches) return false;
    pose_ = pose;
    return true;
}

ToolPose ToolMover::parkedAbove(const ToolPose& hand) noexcept {
    ToolPose pose = wanted(hand);
    const double spacing = layers_.spacing();
    for (int i = 0; i < parkingSamples; ++i) {
        const double clearance = layers_.at(pose, spacing).clearance;
        if (!(clearance < 0.0)) return pose;
        pose.tip += std::max(-clearance, spacing) * pose.axis;
    }
    pose.tip.z = std::max(pose.tip.z, topOfWorkpiece_);
    return pose;
}

ToolMotion ToolMover::move(const ToolPose& hand, double period, CutTick& cut) noexcept {
    ToolMotion motion{pose_, pose_};
    if (stock_ != nullptr) lookAtStock(cut);
    layers_.settle(pose_);
    const ToolPose standing = allowance_.advance(proxy_, pose_, period);
    const ToolPose goal = wanted(hand);
    ProxyStep step = proxy_.advance(standing, goal, stride(period));
    if (barred(step.pose, cut, motion)) {
        motion.barred = true;
        step = aroundContact(standing, goal, stride(period), cut, motion);
    }
    motion.to = step.pose;
    if (step.onBoundary) motion.normal = step.normal;
    if (axis_.free) motion.turnBehind = turnBetween(goal.axis, motion.to.axis);
    motion.axisHeld = step.axisHeld && yields_ == ProxyStride::Yields::tip;
    return motion;
}

/// Stock that was put back, or that a stopped tool was moved into, does not push the tool out.
void ToolMover::lookAtStock(const CutTick& cut) noexcept {
    stock_->beginTick(cut.owed(), cut.spindleTurns());
    layers_.waitInside(layers_.size() - 1, pose_);
}

void ToolMover::workpieceChanged() noexcept {
    brake_.workpieceChanged();
    if (stock_ != nullptr) stock_->workpieceChanged();
}

/// A tool that is held sideways can still be pulled out along its axis.
ProxyStep ToolMover::aroundContact(const ToolPose& standing, const ToolPose& goal, ProxyStride stride, CutTick& cut,
                                   ToolMotion& motion) noexcept {
    const double out = glm::dot(goal.tip - standing.tip, standing.axis);
    stride.turn = 0.0;
    ProxyStep step =
        proxy_.advance(standing, {standing.tip + std::max(out, 0.0) * standing.axis, standing.axis}, stride);
    if (step.pose.tip != pose_.tip && !barred(step.pose, cut, motion)) return step;
    ProxyStep stays;
    stays.pose = pose_;
    stays.axisHeld = axis_.free && glm::length(goal.axis - pose_.axis) > Proxy::axisTolerance;
    return stays;
}

bool ToolMover::barred(const ToolPose& to, CutTick& cut, ToolMotion& motion) noexcept {
    if (!cut.spindleTurns()) return false;
    const ShankContact contact = brake_.onTheWay(cut.workpiece(), cut.owed(), pose_, to);
    if (contact.touches) shank_ = contact;
    motion.shankContact = motion.shankContact || contact.touches;
    return contact.touches ||
           (cut.memoryFull() && brake_.onTheWayWithFlutes(cut.workpiece(), cut.owed(), pose_, to).touches);
}

void ToolMover::arrive(const ToolMotion& motion) noexcept {
    pose_ = motion.to;
    if (motion.barred) allowance_.limitTo(pose_);
}

} // namespace burin
