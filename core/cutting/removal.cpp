// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"

#include "core/cutting/pose_steps.h"
#include "core/cutting/solid_cutter.h"
#include "core/cutting/window_cutter.h"
#include "core/geometry/upright.h"
#include "core/tool/tool_solid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

// Above this step the flux through the surface, a first-order value, is worse than the volume itself.
constexpr double longestFluxStep = 0.3; // voxels
// A larger ball removes so many scanlines a tick that the volume itself is smooth enough (README).
constexpr double largestFluxBall = 30.0; // voxels
// If the flux is not reported, the engagement is measured only once in this many cuts: a hand's engagement changes
// little in as many milliseconds, and a measurement costs some microseconds.
constexpr int cutsPerLook = 16;
// Share of the pending difference that a tick reports: slow compared with the rows of scanlines, fast compared with the
// hand.
constexpr double pendingShare = 1.0 / 48.0;
// While there is flux, at most `evenShare` of the flux is reported of the pending difference at once, and of the excess
// only `excessShare`: if the runs lie across the spindle, a ramp removes a whole layer of scanlines in one tick, which
// the flux has already reported continuously.
constexpr double evenShare = 1.0 / 4.0, excessShare = 1.0 / 8.0;
// Motion over which the volume of a tool that doesn't turn is reported: it removes rows of voxels at a time.
constexpr double spreadVoxels = 2.0;

/// Returns the part of the pending difference that a tick reports in addition to the flux.
double dueOf(double pending, double flux) noexcept {
    const double all = pending * pendingShare;
    if (flux <= 0.0) return all;
    const double even = std::clamp(all, -evenShare * flux, evenShare * flux);
    return even + (all - even) * excessShare;
}

/// Moves the entries of materials that lost or report something to the front.
void keepUsed(CutResult& result) noexcept {
    auto* used = result.removed.begin();
    auto* const end = std::ranges::find(result.removed, airProperty, &MaterialVolume::property);
    for (auto* material = result.removed.begin(); material != end; ++material)
        if (material->units > 0 || material->reported > 0.0) *used++ = *material;
    std::fill(used, end, MaterialVolume{});
}

SurfaceFlux surfaceOf(const Cutter& cutter, double edge) {
    if (cutter.isHollow()) return {cutter.solid->section, cutter.fluteLength, edge};
    return {flutePieces(cutter), edge};
}

} // namespace

MaterialRemoval::MaterialRemoval(const Cutter& cutter, const Grid& grid, Writing writing,
                                 std::shared_ptr<const SolidColumns> columns)
    : sweep_(flutePieces(cutter), grid.edge()), surface_(surfaceOf(cutter, grid.edge())), turns_(cutter.turns()) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const RevolvedPiece& first = flutes.front();
    const bool known = flutes.size() == 1 && WindowCutter::serves(first);
    const bool isBall = known && first.cornerRadius == first.bottomRadius;
    reportsFlux_ = !isBall || first.bottomRadius <= largestFluxBall * grid.edge();
    reach_ = reachOf(flutes);
    cutsSinceLook_ = cutsPerLook; // so that the first cut measures the engagement
    if (cutter.solid != nullptr)
        solid_ = std::make_unique<SolidCutter>(columns ? std::move(columns) : columnsOf(cutter, grid));
    else if (known && writing == Writing::deferred)
        cutter_ = std::make_unique<WindowCutter>(first, grid);
}

MaterialRemoval::~MaterialRemoval() = default;

CutResult MaterialRemoval::account(const RunVolume& workpiece, const RemovedUnits& removed) const noexcept {
    CutResult result;
    const Grid& grid = workpiece.grid();
    const double unitVolume = grid.unitVolume();
    result.outOfMemory = removed.outOfMemory;
    result.volume = static_cast<double>(removed.total) * unitVolume;
    if (removed.total > 0) result.centroid = centroidOf(removed, grid);
    std::size_t entry = 0;
    const PropertyList& properties = workpiece.properties();
    for (int i = 1; i < properties.size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        if (properties.isProtected(property)) continue;
        assert(entry < result.removed.size()); // PropertyList holds no more machinable ones
        const std::uint64_t lost = removed.byProperty[property];
        result.removed[entry++] = {property, lost, static_cast<double>(lost) * unitVolume, 0.0};
    }
    return result;
}

CutResult MaterialRemoval::cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept {
    glm::dvec3 axis(0.0);
    axis[workpiece.grid().axisOfRuns()] = 1.0;
    return cut(workpiece, {fromTip, axis}, {toTip, axis});
}

CutResult MaterialRemoval::cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to) noexcept {
    if (!isFinite(from.tip) || !isFinite(to.tip) || !isFinite(from.axis) || !isFinite(to.axis)) return {};
    RemovedUnits removed;
    bool putOff = false;
    if (cutter_) {
        putOff = cutter_->cut(workpiece, from, to, removed);
    } else if (solid_) {
        assert(isUpright(from.axis) && isUpright(to.axis)); // others are refused before
        solid_->cut(workpiece, from.tip, to.tip, removed);
    } else {
        sweep_.cut(workpiece, from, to, removed);
    }
    CutResult result = account(workpiece, removed);
    result.putOff = putOff;
    if (!turns_)
        reportSpread(workpiece, from, to, result);
    else
        report(workpiece, from, to, result);
    return result;
}

void MaterialRemoval::approach(RunVolume& workpiece, const ToolPose& pose) noexcept {
    if (cutter_ && isFinite(pose.tip) && isFinite(pose.axis)) cutter_->approach(workpiece, pose);
}

CutResult MaterialRemoval::settle(RunVolume& workpiece) noexcept {
    if (!cutter_) return {}; // also if nothing is pending, so that reserved memory is returned
    RemovedUnits removed;
    cutter_->settle(workpiece, removed);
    CutResult result = account(workpiece, removed);
    for (const MaterialVolume& material : result.removed) pending_[material.property] += material.volume;
    keepUsed(result);
    return result;
}

Engagement MaterialRemoval::engagement(const RunVolume& workpiece, const ToolPose& from,
                                       const ToolPose& to) const noexcept {
    if (!turns_) return {}; // its surface is not that of the pieces
    SurfaceFlux::Flux flux;
    const bool known = isFinite(from.tip) && isFinite(to.tip) && isFinite(from.axis) && isFinite(to.axis);
    if (known && (from.tip != to.tip || from.axis != to.axis)) surface_.measure(workpiece, window(), from, to, flux);
    return flux.engagement;
}

Engagement MaterialRemoval::recentEngagement(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                                             bool removes) noexcept {
    cutsSinceLook_ = std::min(cutsSinceLook_ + 1, cutsPerLook);
    if (!removes) return {};
    // If a tool only just touches the material, a measurement may find no engagement yet.
    if (cutsSinceLook_ >= cutsPerLook || lastLook_.area == 0.0) {
        lastLook_ = engagement(workpiece, from, to);
        cutsSinceLook_ = 0;
    }
    return lastLook_;
}

const CutCache* MaterialRemoval::window() const noexcept {
    return cutter_ ? &cutter_->window() : nullptr;
}

bool MaterialRemoval::settled() const noexcept {
    return !cutter_ || cutter_->settled();
}

void MaterialRemoval::reset() noexcept {
    if (cutter_) cutter_->reset();
    if (solid_) solid_->reset();
    pending_.fill(0.0);
    lastPlace_ = glm::dvec3(0.0);
    cutsSinceLook_ = cutsPerLook;
}

/// After passing a border, the material that the tool has left must not be felt any more: the pending difference of all
/// materials is shared out among those that it meets now.
void MaterialRemoval::passOnPending(const SurfaceFlux::Flux& flux, const CutResult& cut) noexcept {
    if (cut.removed[1].property == airProperty) return; // one material
    double all = 0.0;
    for (const MaterialVolume& material : cut.removed) all += pending_[material.property];
    for (const MaterialVolume& material : cut.removed)
        if (material.property != airProperty)
            pending_[material.property] = all * (flux.volume[material.property] / flux.total);
}

void MaterialRemoval::report(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                             CutResult& result) noexcept {
    const glm::dvec3 tip = to.tip;
    // mm, upper bound of the motion of any point of the flutes.
    const double step = glm::length(tip - from.tip) + glm::length(to.axis - from.axis) * reach_;
    const bool moves = step > 0.0, small = reportsFlux_ && step < longestFluxStep * workpiece.grid().edge();
    std::optional<SurfaceFlux::Flux> flux;
    if (moves && small) {
        surface_.measure(workpiece, window(), from, to, flux.emplace());
        result.engagement = lastLook_ = flux->engagement;
        cutsSinceLook_ = 0;
    } else if (!small) {
        result.engagement = recentEngagement(workpiece, from, to, result.volume > 0.0);
    }
    if (flux && flux->total > 0.0) passOnPending(*flux, result);
    for (MaterialVolume& material : result.removed) {
        if (material.property == airProperty) break;
        double& pending = pending_[material.property];
        const double now = flux ? flux->volume[material.property] : small ? 0.0 : material.volume;
        if (moves) material.reported = std::max(0.0, now + dueOf(pending, small ? now : 0.0));
        pending += material.volume - material.reported;
        result.reported += material.reported;
    }
    if (flux && flux->total > 0.0) {
        lastPlace_ = flux->moment / flux->total - tip;
    } else if (result.volume > 0.0) {
        lastPlace_ = result.centroid - tip;
    }
    result.reportedCentroid = tip + lastPlace_;
    keepUsed(result);
}

void MaterialRemoval::reportSpread(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                                   CutResult& result) noexcept {
    const double share = std::min(1.0, glm::length(to.tip - from.tip) / (spreadVoxels * workpiece.grid().edge()));
    for (MaterialVolume& material : result.removed) {
        if (material.property == airProperty) break;
        double& pending = pending_[material.property];
        pending += material.volume;
        material.reported = share * pending;
        pending -= material.reported;
        result.reported += material.reported;
    }
    if (result.volume > 0.0) lastPlace_ = result.centroid - to.tip;
    result.reportedCentroid = to.tip + lastPlace_;
    keepUsed(result);
}

} // namespace burin
