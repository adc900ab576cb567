// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/tool_mover.h"

#include "core/haptics/reading_guard.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double voxelsPerTick = 6.0; // of travel, at least
constexpr int parkingSamples = 256;

} // namespace

ToolMover::ToolMover(const ClearanceField& field, const Tool& tool, const Grid& grid, const HapticSettings& settings)
    : topOfWorkpiece_(grid.box().high.z)
    , spacing_(field.spacing())
    , slowestTravel_(voxelsPerTick * grid.edge() / settings.tickPeriod)
    , handSpeed_(settings.stylus.maximumSpeed.value)
    , longestPeriod_(ReadingGuard::lateTicks * settings.tickPeriod)
    , brake_(tool.cutter, grid)
    , proxy_(field)
    , allowance_(settings.allowance) {
    setScale(settings.mapping.scale);
}

/// A tool as fast as the fastest hand that is believed follows it without a lag, hence without a force.
void ToolMover::setScale(double scale) noexcept {
    travelPerSecond_ = std::max(slowestTravel_, 1.1 * handSpeed_ * scale);
}

bool ToolMover::start(const ToolPose& hand, const CutTick& cut) noexcept {
    allowance_.settle();
    if (!proxy_.feasible(hand.tip, allowance_.inForce())) return false;
    if (cut.spindleTurns() && brake_.at(cut.workpiece(), hand.tip).touches) return false;
    pose_.tip = hand.tip;
    return true;
}

ToolPose ToolMover::parkedAbove(const ToolPose& hand) const noexcept {
    ToolPose pose{hand.tip};
    for (int i = 0; i < parkingSamples; ++i) {
        const double missing = allowance_.inForce() - proxy_.clearance(pose.tip);
        if (!(missing > 0.0)) return pose;
        pose.tip.z += std::max(missing, spacing_);
    }
    pose.tip.z = std::max(pose.tip.z, topOfWorkpiece_);
    return pose;
}

ToolMotion ToolMover::move(const ToolPose& hand, double period, CutTick& cut) noexcept {
    const double travel = travelPerSecond_ * std::min(period, longestPeriod_);
    ToolMotion motion{pose_, pose_};
    const glm::dvec3 standing = allowance_.advance(proxy_, pose_.tip, period);
    ProxyStep step = proxy_.advance(standing, hand.tip, allowance_.inForce(), travel);
    if (barred(step.tip, cut, motion)) {
        motion.barred = true;
        // Held sideways, a tool can still be pulled out along its axis.
        const glm::dvec3 above(standing.x, standing.y, std::max(standing.z, hand.tip.z));
        step = proxy_.advance(standing, above, allowance_.inForce(), travel);
        if (step.tip == pose_.tip || barred(step.tip, cut, motion)) step = {pose_.tip, false, glm::dvec3(0.0), 0};
    }
    motion.to.tip = step.tip;
    if (step.onBoundary) motion.normal = step.normal;
    return motion;
}

bool ToolMover::barred(const glm::dvec3& to, CutTick& cut, ToolMotion& motion) noexcept {
    if (!cut.spindleTurns()) return false;
    ShankContact contact = brake_.onTheWay(cut.workpiece(), pose_.tip, to);
    // What is touched may be gone, though not yet written.
    if (contact.touches && !cut.settled()) {
        cut.settle();
        contact = brake_.onTheWay(cut.workpiece(), pose_.tip, to);
    }
    if (contact.touches) shank_ = contact;
    motion.shankContact = motion.shankContact || contact.touches;
    return contact.touches || (cut.memoryFull() && brake_.onTheWayWithFlutes(cut.workpiece(), pose_.tip, to).touches);
}

void ToolMover::arrive(const ToolMotion& motion) noexcept {
    pose_ = motion.to;
    if (motion.barred) allowance_.limitTo(proxy_.clearance(pose_.tip));
}

} // namespace burin
