// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/surface_flux.h"
#include "core/tool/swept_span.h"
#include "core/tool/tool.h"
#include "core/volume/run_volume.h"

#include <array>
#include <cstdint>

namespace burin {

/// Volume of one material, mm³.
struct MaterialVolume {
    PropertyIndex property = airProperty; ///< air: entry not used
    std::uint64_t units = 0;              ///< run units: exact
    double volume = 0.0;                  ///< mm³, units times Grid::unitVolume
    double reported = 0.0;                ///< mm³, smooth over ticks (design.md section 3); sums follow `volume`
};

/// What one cut took away.
struct CutResult {
    /// One entry a material that lost or reports something, in the order of the property list; the rest is not used.
    std::array<MaterialVolume, maximumMachinableProperties> removed{};
    double volume = 0.0;      ///< mm³, all materials, exact
    double reported = 0.0;    ///< mm³, all materials, smooth
    glm::dvec3 centroid{0.0}; ///< mm, of what was removed, setup frame; meaningless when volume is 0
    /// mm, of what is reported, setup frame, from tick to tick as smooth as that; meaningless when `reported` is 0.
    glm::dvec3 reportedCentroid{0.0};
    bool outOfMemory = false; ///< reserved memory of the volume is used up; lines from there on are uncut
};

/// Takes what the flutes sweep between two tips (axis along the runs) out of the machinable runs of a workpiece.
/// Keeps the state that the smooth figure needs from tick to tick; one object a tool and workpiece.
/// The tool's axis is +Z and the workpiece's runs lie along z (asserted).
/// No allocation, lock or exception in `cut`.
class MaterialRemoval {
public:
    MaterialRemoval(const Cutter& cutter, const Grid& grid);

    /// A tip that is not finite removes nothing; neither does a tool that stands still where it arrived.
    /// The reported volume is the flux through the flutes' surface for moves below 0.3 voxel and the exact one above;
    /// 1/64 of what the sum of the reported lags the exact one is added each tick that the tool moves.
    /// Cost: grows with the scanlines under the cutter, not with the grid.
    CutResult cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;
    /// Forgets what is still to be reported: the workpiece changed by other means, or the tool was taken elsewhere.
    void reset() noexcept;

private:
    struct Tally;
    Tally takeAway(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;
    void report(const RunVolume& workpiece, const glm::dvec3& tip, const glm::dvec3& motion,
                CutResult& result) noexcept;

    RevolvedPiece flutes_;
    SurfaceFlux surface_;
    std::array<double, 256> pending_{}; ///< mm³ by property, by which the reported sum lags the exact one
    glm::dvec3 lastPlace_{0.0};         ///< mm from the tip, of what was reported last
};

} // namespace burin
