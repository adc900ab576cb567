// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/surface_flux.h"
#include "core/cutting/sweep_cutter.h"
#include "core/geometry/pose.h"
#include "core/tool/swept_span.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

class WindowCutter;

/// Volume of one material, mm³.
struct MaterialVolume {
    PropertyIndex property = airProperty; ///< air: entry not used
    std::uint64_t units = 0;              ///< run units: exact
    double volume = 0.0;                  ///< mm³, units times Grid::unitVolume
    /// mm³, smooth over ticks (README.md). Sums over all materials follow `volume`; those of one material may be off by
    /// a layer of voxels at a border that the tool passed.
    double reported = 0.0;
};

/// What one cut took away.
struct CutResult {
    /// One entry a material that lost or reports something, in the order of the property list; the rest is not used.
    std::array<MaterialVolume, maximumMachinableProperties> removed{};
    double volume = 0.0;   ///< mm³, all materials, exact
    double reported = 0.0; ///< mm³, all materials, smooth
    /// mm, of what was removed, setup frame; meaningless when volume is 0. Right to 1e-9 mm written at once; deferred,
    /// as the sums are of single precision, to 2^-23 of the grid's diagonal.
    glm::dvec3 centroid{0.0};
    /// mm, of what is reported, setup frame, from tick to tick as smooth as that; meaningless when `reported` is 0.
    glm::dvec3 reportedCentroid{0.0};
    /// How the flutes stand in material: where the flux is reported (`MaterialRemoval::cut`) at the end of this very
    /// move, elsewhere as looked at in one of the last 16 cuts. All 0 where nothing is removed or reported.
    /// The directions that belong to it, of the motion and away from the material, are `CuttingForce`'s.
    Engagement engagement;
    bool outOfMemory = false; ///< reserved memory of the volume is used up; lines from there on are uncut
    /// Part of the way is put off to bound the tick's work: the next cuts, or `settle`, take it and count it then.
    bool putOff = false;
};

/// When a cut reaches the workpiece's runs.
enum class Writing : std::uint8_t {
    everyCut, ///< before `cut` returns
    deferred, ///< within 16 cuts, or with `settle`: for loops of short moves, many times faster
};

/// Takes what the flutes sweep between two poses out of the machinable runs of a workpiece.
/// Keeps the state that the smooth figure needs from tick to tick; one object a tool and workpiece.
/// No allocation, lock or exception in `cut`, `approach` and `settle`. Thread: the workpiece's writer.
///
/// Deferred writing: `CutResult` counts at once and exactly, but the runs follow later. Whoever reads the workpiece
/// for good (undo, saving, amounts, a recount) or changes it otherwise calls `settle` first; pictures need not.
/// What is pending when the object goes is lost.
class MaterialRemoval {
public:
    /// Allocates. @param grid of every workpiece that is cut
    MaterialRemoval(const Cutter& cutter, const Grid& grid, Writing writing = Writing::everyCut);
    ~MaterialRemoval();

    /// The tool's axis lies along the runs, +.
    /// A tip that is not finite removes nothing; neither does a tool that stands still where it arrived.
    /// The reported volume is the flux through the flutes' surface for moves of no point of them by 0.3 voxel or more,
    /// whatever the axes of tool and runs, and the exact one above and for a ball of more than 30 voxels of radius;
    /// 1/48 of what the sum of the reported lags the exact one is added each tick that the tool moves; beyond a quarter
    /// of the flux 1/384 of it.
    /// Cost: grows with the scanlines under the cutter, not with the grid.
    CutResult cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;
    /// The same with any axis, which may turn on the way.
    CutResult cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to) noexcept;
    /// Gets ready, within a tick's bounds, for a cut that may begin at this pose, so that the first contact of a large
    /// tool is not dear. Cuts nothing. For every tick in which the tool moves without cutting.
    void approach(RunVolume& workpiece, const ToolPose& pose) noexcept;
    /// Writes all that is pending to the workpiece and takes what was put off, which alone its result counts. Gives
    /// back the memory that was set aside for more, which is lost to the workpiece when the object goes or is reset
    /// without. Cost: up to that of a first contact.
    CutResult settle(RunVolume& workpiece) noexcept;
    /// True when the workpiece's runs show every cut.
    bool settled() const noexcept;
    /// Forgets the workpiece, what is pending and what is still to be reported: it was changed by other means.
    void reset() noexcept;

    /// How the flutes stand, at the end of a move, in the material that the same motion pushes them into next. Any
    /// cutter and axes; moves of any length; all 0 for a tool that stands still. Cost: a look at some hundreds of
    /// scanlines, up to tens of microseconds, which a cut that reports the exact volume pays in every 16th tick.
    Engagement engagement(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to) const noexcept;

    /// What the workpiece is owed, for tests of contact between cuts; nothing: nothing ever is.
    const GapWindow* window() const noexcept;

private:
    CutResult account(const RunVolume& workpiece, const RemovedUnits& removed) const noexcept;
    void passOnPending(const SurfaceFlux::Flux& flux, const CutResult& cut) noexcept;
    void report(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to, CutResult& result) noexcept;
    Engagement recentEngagement(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                                bool removes) noexcept;

    SweepCutter sweep_;
    std::unique_ptr<WindowCutter> cutter_; ///< none: written with every cut, or of a form that it does not serve
    SurfaceFlux surface_;
    double reach_ = 0.0; ///< mm, of the flutes from the tip, at most
    bool reportsFlux_ = true;
    Engagement lastLook_; ///< of a cut whose flux is not reported
    int cutsSinceLook_ = 0;
    std::array<double, 256> pending_{}; ///< mm³ by property, by which the reported sum lags the exact one
    glm::dvec3 lastPlace_{0.0};         ///< mm from the tip, of what was reported last
};

} // namespace burin
