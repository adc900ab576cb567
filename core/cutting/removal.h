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

class SolidColumns;
class SolidCutter;
class WindowCutter;

/// Volume of one material, mm³.
struct MaterialVolume {
    PropertyIndex property = airProperty; ///< air: entry not used
    std::uint64_t units = 0;              ///< run units: exact
    double volume = 0.0;                  ///< mm³, units times Grid::unitVolume
    /// mm³, smooth over ticks (README.md). The sum over all materials follows `volume`; that of one material may be off
    /// by a layer of voxels at a border that the tool has passed.
    double reported = 0.0;
};

/// The material that one cut removed.
struct CutResult {
    /// One entry for each material that lost or reports volume, in the order of the property list; the others are
    /// unused.
    std::array<MaterialVolume, maximumMachinableProperties> removed{};
    double volume = 0.0;   ///< mm³, all materials, exact
    double reported = 0.0; ///< mm³, all materials, smooth
    /// mm, centroid of the removed material, setup frame; meaningless if volume is 0. Accurate to 1e-9 mm when written
    /// at once; with deferred writing, where the sums have single precision, to 2^-23 of the grid's diagonal.
    glm::dvec3 centroid{0.0};
    /// mm, centroid of the reported volume, setup frame, as smooth over ticks; meaningless if `reported` is 0.
    glm::dvec3 reportedCentroid{0.0};
    /// The engagement of the flutes: if the flux is reported (`MaterialRemoval::cut`), that at the end of this very
    /// move, otherwise that measured in one of the last 16 cuts. All 0 if nothing is removed or reported.
    /// The corresponding directions, of the motion and away from the material, are in `CuttingForce`.
    Engagement engagement;
    bool outOfMemory = false; ///< reserved memory of the volume is used up; lines from there on are uncut
    /// Part of the move is put off to bound the tick's work: the next cuts, or `settle`, remove and count it then.
    bool putOff = false;
};

/// When a cut is written to the workpiece's runs.
enum class Writing : std::uint8_t {
    everyCut, ///< before `cut` returns
    deferred, ///< within 16 cuts, or with `settle`: for loops of short moves, many times faster
};

/// Removes the volume that the flutes sweep between two poses from the machinable runs of a workpiece. A tool that
/// doesn't turn or is hollow is swept as the solid that it is (SolidCutter), upright, and written with every cut: along
/// the runs exact to a run unit, sideways within an eighth of a voxel along each axis (SolidColumns).
/// Keeps the state of the smooth reported volume from tick to tick; use one object for each tool and workpiece.
/// No allocation, lock or exception in `cut`, `approach` and `settle`. Only on the workpiece's writer thread.
///
/// Deferred writing: `CutResult` counts at once and exactly, but the runs follow later. Call `settle` before reading
/// the workpiece for a permanent result (undo, saving, amounts, a recount) or changing it in another way; display does
/// not need it. Writes that are pending when the object is destroyed are lost.
class MaterialRemoval {
public:
    /// Allocates. @param grid that of every workpiece that is cut @param columns those of the cutter on this grid, if
    /// they are shared; null: they are made if the cutter has a solid
    MaterialRemoval(const Cutter& cutter, const Grid& grid, Writing writing = Writing::everyCut,
                    std::shared_ptr<const SolidColumns> columns = nullptr);
    ~MaterialRemoval();

    /// The tool's axis points along the runs in the positive direction.
    /// A tip that is not finite removes nothing; neither does a tool that rests where its last move ended.
    /// The reported volume is the flux through the flutes' surface for moves in which no point of the flutes moves by
    /// 0.3 voxel or more, whatever the axes of tool and runs; for longer moves, and for a ball of more than 30 voxels
    /// of radius, it is the exact volume. 1/48 of the lag of the reported sum behind the exact one is added in each
    /// tick in which the tool moves; of the lag beyond a quarter of the flux only 1/384. Of a tool that doesn't turn
    /// the reported volume is the exact one, spread over two voxels of its motion, and the engagement stays 0. Cost:
    /// grows with the scanlines under the cutter, not with the grid.
    CutResult cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;
    /// The same with any axis, which may rotate during the move; a tool with a solid has to be upright (asserted).
    CutResult cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to) noexcept;
    /// Prepares, within a tick's bounds, for a cut that may begin at this pose, so that the first contact of a large
    /// tool is not expensive. Cuts nothing. Call it in every tick in which the tool moves without cutting.
    void approach(RunVolume& workpiece, const ToolPose& pose) noexcept;
    /// Writes everything that is pending to the workpiece and removes what was put off; the result counts only the
    /// latter. Returns the memory that was set aside for more; without `settle` this memory is lost to the workpiece
    /// when the object is destroyed or reset. Cost: up to that of a first contact.
    CutResult settle(RunVolume& workpiece) noexcept;
    /// Whether the workpiece's runs show every cut.
    bool settled() const noexcept;
    /// Forgets the workpiece, all pending writes and the volume still to be reported; call after other changes to it.
    void reset() noexcept;

    /// Returns the engagement, at the end of a move, with the material that the same motion would enter next. Any
    /// cutter and axes; moves of any length; all 0 for a tool at rest. Cost: reads some hundreds of scanlines, up to
    /// tens of microseconds, which a cut that reports the exact volume spends in every 16th tick.
    Engagement engagement(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to) const noexcept;

    /// The pending writes to the workpiece, for contact checks between cuts; null if cuts are always written at once.
    const CutCache* window() const noexcept;

private:
    CutResult account(const RunVolume& workpiece, const RemovedUnits& removed) const noexcept;
    void passOnPending(const SurfaceFlux::Flux& flux, const CutResult& cut) noexcept;
    void report(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to, CutResult& result) noexcept;
    Engagement recentEngagement(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                                bool removes) noexcept;
    void reportSpread(const RunVolume& workpiece, const ToolPose& from, const ToolPose& to, CutResult& result) noexcept;

    SweepCutter sweep_;
    std::unique_ptr<WindowCutter> cutter_; ///< null: written with every cut, or a form of tool that it does not support
    std::unique_ptr<SolidCutter> solid_;   ///< null: the flutes are the pieces
    SurfaceFlux surface_;
    double reach_ = 0.0; ///< mm, largest distance of the flutes from the tip
    bool reportsFlux_ = true, turns_ = true;
    Engagement lastLook_; ///< of a cut whose flux is not reported
    int cutsSinceLook_ = 0;
    std::array<double, 256> pending_{}; ///< mm³ by property, lag of the reported sum behind the exact one
    glm::dvec3 lastPlace_{0.0};         ///< mm from the tip, centroid of the last reported volume
};

} // namespace burin
