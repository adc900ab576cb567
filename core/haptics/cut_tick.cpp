// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/cut_tick.h"

#include "core/haptics/recorded_removal.h"

#include <algorithm>
#include <limits>

namespace burin {
namespace {

// A tool that cuts takes a row of scanlines at least so often. The reported removal looks a voxel ahead; without this
// a tool on its way to the stock would feel it before it touches.
constexpr double idleVoxels = 2.0;

} // namespace

CutTick::CutTick(RunVolume& workpiece, const Tool& tool, const HapticSettings& settings)
    : workpiece_(&workpiece)
    , coefficients_(cuttingCoefficients(workpiece.properties()))
    , removal_(tool.cutter, workpiece.grid(), Writing::deferred)
    , cuttingSpeed_(settings.cuttingSpeed)
    , onButton_(settings.cutsOnButton) {}

void CutTick::takeUp() noexcept {
    takesUp_ = true;
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
}

CuttingForce CutTick::operator()(ToolMotion& motion, double period, Sample& sample) noexcept {
    const bool stands = !spindleTurns();
    if (stands) travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    if (stands || takesUp_ || motion.shankContact || memoryFull_) {
        removal_.approach(*workpiece_, motion.to);
        takesUp_ = false;
        return {};
    }
    const CutResult cut = take(motion.from, motion.to);
    recordRemoval(cut, workpiece_->properties(), sample);
    sample.reportedRemoval = cut.reported;
    const glm::dvec3 way = motion.way();
    travelSinceRemoval_ = cut.volume > 0.0 ? 0.0 : travelSinceRemoval_ + glm::length(way);
    CuttingForce force;
    if (travelSinceRemoval_ <= idleVoxels * workpiece_->grid().edge())
        force = cuttingForce(cut, coefficients_, way, motion.to.tip, cuttingSpeed_, period);
    sample.cuttingForce = force.force;
    if (cut.outOfMemory) {
        memoryFull_ = true;
        sample.flags |= sampleMemoryFull;
        motion.to = motion.from;
        motion.normal = glm::dvec3(0.0);
        motion.barred = true;
    }
    return force;
}

/// A sample holds all that was cut between it and the one before, so that replaying takes gives the same workpiece:
/// what a cut would put off is taken at once. `approach` has made that rare.
CutResult CutTick::take(const ToolPose& from, const ToolPose& to) noexcept {
    CutResult cut = removal_.cut(*workpiece_, from, to);
    if (!cut.putOff || cut.outOfMemory) return cut;
    const CutResult rest = removal_.settle(*workpiece_);
    const double volume = cut.volume + rest.volume;
    if (volume > 0.0) cut.centroid = (cut.centroid * cut.volume + rest.centroid * rest.volume) / volume;
    cut.volume = volume;
    cut.outOfMemory = rest.outOfMemory;
    for (const MaterialVolume& more : rest.removed) {
        if (more.property == airProperty) continue;
        const auto same = std::find_if(cut.removed.begin(), cut.removed.end(), [&](const MaterialVolume& one) {
            return one.property == more.property || one.property == airProperty;
        });
        same->property = more.property;
        same->units += more.units;
        same->volume += more.volume;
    }
    return cut;
}

void CutTick::settle() noexcept {
    if (removal_.settle(*workpiece_).outOfMemory) memoryFull_ = true;
}

void CutTick::workpieceChanged() noexcept {
    removal_.reset();
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    memoryFull_ = false;
}

} // namespace burin
