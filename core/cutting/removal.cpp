// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"

#include "core/cutting/footprint.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cassert>

namespace burin {

namespace {

// Above this step the flux through the surface, a first-order figure, is worse than the volume itself.
constexpr double longestFluxStep = 0.3; // voxels
// Share of the pending difference that a tick reports: slow beside the rows of scanlines, fast beside the hand.
constexpr double pendingShare = 1.0 / 64.0;

} // namespace

/// What one cut took, as it is counted scanline by scanline.
struct MaterialRemoval::Tally {
    RunAmounts removed;
    std::uint64_t units = 0;
    glm::dvec3 moment{0.0}; ///< mm times units
    bool outOfMemory = false;
};

MaterialRemoval::MaterialRemoval(const Cutter& cutter, const Grid& grid, Writing)
    : flutes_(burin::flutes(cutter)), surface_(flutes_, grid.edge()) {}

MaterialRemoval::Tally MaterialRemoval::takeAway(RunVolume& workpiece, const glm::dvec3& fromTip,
                                                 const glm::dvec3& toTip) noexcept {
    Tally tally;
    const Grid& grid = workpiece.grid();
    const PropertyList& properties = workpiece.properties();
    const auto take = [&](LineIndex line, RunPosition from, RunPosition to) {
        std::uint64_t units = 0;
        double along = 0.0; // mm times units
        forEachPiece(workpiece.line(line), from, to, [&](PropertyIndex property, RunPosition start, RunPosition end) {
            if (properties.isProtected(property)) return;
            units += end - start;
            along += 0.5 * (grid.toMillimetres(start) + grid.toMillimetres(end)) * (end - start);
        });
        if (units == 0) return true;
        tally.outOfMemory = workpiece.removeSpan(line, from, to, tally.removed) == Removal::outOfMemory;
        if (tally.outOfMemory) return false;
        tally.units += units;
        tally.moment += glm::dvec3(grid.lineCentre(line) * static_cast<double>(units), along);
        return true;
    };
    forEachSpan(SweptPiece(flutes_, fromTip, toTip), grid, take);
    return tally;
}

CutResult MaterialRemoval::cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept {
    assert(workpiece.grid().axis() == RunAxis::z);
    CutResult result;
    if (!isFinite(fromTip) || !isFinite(toTip)) return result;
    const Tally tally = takeAway(workpiece, fromTip, toTip);
    const double unitVolume = workpiece.grid().unitVolume();
    result.outOfMemory = tally.outOfMemory;
    result.volume = static_cast<double>(tally.units) * unitVolume;
    if (tally.units > 0) result.centroid = tally.moment / static_cast<double>(tally.units);
    std::size_t entry = 0;
    const PropertyList& properties = workpiece.properties();
    for (int i = 1; i < properties.size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        if (properties.isProtected(property)) continue;
        assert(entry < result.removed.size()); // PropertyList holds no more machinable ones
        const std::uint64_t units = tally.removed.units[property];
        result.removed[entry++] = {property, units, static_cast<double>(units) * unitVolume, 0.0};
    }
    report(workpiece, toTip, toTip - fromTip, result);
    return result;
}

CutResult MaterialRemoval::cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to) noexcept {
    return cut(workpiece, from.tip, to.tip);
}

void MaterialRemoval::approach(const RunVolume&, const ToolPose&) noexcept {}

CutResult MaterialRemoval::settle(RunVolume&) noexcept {
    return {};
}

bool MaterialRemoval::settled() const noexcept {
    return true;
}

void MaterialRemoval::reset() noexcept {
    pending_.fill(0.0);
    lastPlace_ = glm::dvec3(0.0);
}

void MaterialRemoval::report(const RunVolume& workpiece, const glm::dvec3& tip, const glm::dvec3& motion,
                             CutResult& result) noexcept {
    const double step = glm::length(motion);
    const bool moves = step > 0.0, small = step < longestFluxStep * workpiece.grid().edge();
    SurfaceFlux::Flux flux;
    if (moves && small) surface_.measure(workpiece, tip, motion, flux);
    for (MaterialVolume& material : result.removed) {
        if (material.property == airProperty) break;
        double& pending = pending_[material.property];
        const double now = small ? flux.volume[material.property] : material.volume;
        if (moves) material.reported = std::max(0.0, now + pending * pendingShare);
        pending += material.volume - material.reported;
        result.reported += material.reported;
    }
    if (flux.total > 0.0) {
        lastPlace_ = flux.moment / flux.total - tip;
    } else if (result.volume > 0.0) {
        lastPlace_ = result.centroid - tip;
    }
    result.reportedCentroid = tip + lastPlace_;
    std::size_t used = 0;
    for (const MaterialVolume& material : result.removed)
        if (material.units > 0 || material.reported > 0.0) result.removed[used++] = material;
    std::fill(result.removed.begin() + static_cast<std::ptrdiff_t>(used), result.removed.end(), MaterialVolume{});
}

} // namespace burin
