// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/cut_tick.h"

#include "core/base/units.h"
#include "core/haptics/recorded_removal.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace burin {
namespace {

// A tool that cuts removes a row of scanlines at least once within this distance. The reported removal looks a voxel
// ahead; without this limit, a tool on its way to the stock would feel the stock before touching it.
constexpr double idleVoxels = 2.0;
// Length in voxels of either filter of the felt area: a ripple with the period of a voxel shrinks to a 90th.
constexpr double areaVoxels = 1.5;

// Share of the felt area: a tick that engages at least this share determines the material around the flutes.
constexpr double tellingShare = 0.5;

/// mm: half a voxel, or two steps of the device's encoders.
double playOf(const Grid& grid, const HapticSettings& settings) noexcept {
    return std::max(0.5 * grid.edge(), 2.0 * settings.stylus.positionStep.value * settings.mapping.scale);
}

/// Depth in mm from the tip: one radius, or the largest depth of cut of the tool.
double referenceDepth(const Tool& tool) noexcept {
    const double radius = tool.cutter.radius();
    return tool.maximumDepthOfCut > 0.0 ? std::min(radius, tool.maximumDepthOfCut) : radius;
}

/// Adds a removed volume of a material, in the order of the property list.
void addInOrder(std::array<MaterialVolume, maximumMachinableProperties>& removed, const MaterialVolume& more) noexcept {
    auto* const place = std::find_if(removed.begin(), removed.end(), [&](const MaterialVolume& one) {
        return one.property >= more.property || one.property == airProperty;
    });
    if (place->property != more.property) {
        std::move_backward(place, removed.end() - 1, removed.end());
        *place = {more.property};
    }
    place->units += more.units;
    place->volume += more.volume;
}

} // namespace

CutTick::CutTick(RunVolume& workpiece, const Tool& tool, const HapticSettings& settings,
                 std::shared_ptr<const SolidColumns> columns)
    : workpiece_(&workpiece)
    , coefficients_(cuttingCoefficients(workpiece.properties(), tool.cutter.diameter))
    , removal_(tool.cutter, workpiece.grid(), Writing::deferred, std::move(columns))
    , tool_(spinningTool(tool, settings.cuttingSpeed))
    , area_(areaVoxels * workpiece.grid().edge(), playOf(workpiece.grid(), settings))
    , onButton_(settings.cutsOnButton) {
    felt_.reference = newtonMillimetresPerJoule * coefficients_.hardest * slotArea(tool.cutter, referenceDepth(tool));
}

void CutTick::takeUp() noexcept {
    takesUp_ = true;
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
}

CuttingForce CutTick::cut(ToolMotion& motion, double period, Sample& sample) noexcept {
    const bool stands = !spindleTurns();
    if (stands) travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    if (stands || takesUp_ || motion.shankContact || memoryFull_) {
        removal_.approach(*workpiece_, motion.to);
        takesUp_ = false;
        area_.fade(period);
        return asFelt({});
    }
    const CutResult cut = take(motion.from, motion.to);
    recordRemoval(cut, workpiece_->properties(), sample);
    sample.reportedRemoval = cut.reported;
    if (cut.engagement.area > 0.0) engagement_ = cut.engagement;
    const glm::dvec3 way = motion.way();
    travelSinceRemoval_ = cut.volume > 0.0 ? 0.0 : travelSinceRemoval_ + glm::length(way);
    CuttingForce force = cuttingForce(cut, coefficients_, tool_, motion.from, motion.to, period);
    if (travelSinceRemoval_ > idleVoxels * workpiece_->grid().edge()) {
        const glm::dvec3 moved = force.motion;
        force = {};
        force.cuts = true;
        force.motion = moved;
    }
    area_.add(force.volume, force.motion);
    sample.cuttingForce = force.force;
    if (cut.outOfMemory) {
        memoryFull_ = true;
        sample.flags |= sampleMemoryFull;
        motion.to = motion.from;
        motion.normal = glm::dvec3(0.0);
        motion.barred = true;
    }
    return asFelt(force);
}

CuttingForce CutTick::asFelt(const CuttingForce& force) noexcept {
    if (force.area > 0.0) {
        // A tick that has its share of the area determines the mix at once. A tick that only reports volume that the
        // runs were lagging behind, perhaps of the previous material, says nothing about the material around the
        // flutes.
        const double share = std::clamp(force.area / (tellingShare * area_.value()), 0.0, 1.0), weight = share * share;
        felt_.energy += weight * (force.energy - felt_.energy);
        felt_.radialRatio += weight * (force.radialRatio - felt_.radialRatio);
        felt_.away = force.away;
    }
    CuttingForce result = force;
    result.area = area_.value();
    result.energy = felt_.energy;
    result.radialRatio = felt_.radialRatio;
    result.away = felt_.away;
    result.reference = felt_.reference;
    return result;
}

/// A sample contains everything that was cut since the previous one, so that replaying takes gives the same workpiece:
/// the part of a cut that would be put off is carried out at once. `approach` has made that rare.
CutResult CutTick::take(const ToolPose& from, const ToolPose& to) noexcept {
    CutResult cut = removal_.cut(*workpiece_, from, to);
    if (!cut.putOff || cut.outOfMemory) return cut;
    const CutResult rest = removal_.settle(*workpiece_);
    const double volume = cut.volume + rest.volume;
    if (volume > 0.0) cut.centroid = (cut.centroid * cut.volume + rest.centroid * rest.volume) / volume;
    cut.volume = volume;
    cut.outOfMemory = rest.outOfMemory;
    for (const MaterialVolume& more : rest.removed) {
        if (more.property == airProperty) break;
        addInOrder(cut.removed, more);
    }
    return cut;
}

void CutTick::settle() noexcept {
    if (removal_.settle(*workpiece_).outOfMemory) memoryFull_ = true;
}

void CutTick::workpieceChanged() noexcept {
    removal_.reset();
    area_.reset();
    travelSinceRemoval_ = std::numeric_limits<double>::infinity();
    memoryFull_ = false;
}

} // namespace burin
