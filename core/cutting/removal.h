// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/swept_span.h"
#include "core/tool/tool.h"
#include "core/volume/run_volume.h"

#include <array>

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
    std::array<MaterialVolume, maximumMachinableProperties> removed{};
    double volume = 0.0;        ///< mm³, all materials, exact
    double reported = 0.0;      ///< mm³, all materials, smooth
    glm::dvec3 centroid{0.0};   ///< mm, of what was removed, setup frame; meaningless when volume is 0
    bool outOfMemory = false;   ///< reserved memory of the volume is used up; lines from there on are uncut
};

/// Takes what the flutes sweep between two tips (axis along the runs) out of the machinable runs of a workpiece.
/// Keeps the state that the smooth figure needs from tick to tick; one object a tool and workpiece.
/// No allocation, lock or exception in `cut`.
class MaterialRemoval {
public:
    MaterialRemoval(const Cutter& cutter, const Grid& grid);

    /// Cost: grows with the scanlines under the cutter, not with the grid.
    CutResult cut(RunVolume& workpiece, const glm::dvec3& fromTip, const glm::dvec3& toTip) noexcept;

private:
    RevolvedPiece flutes_;
    double pending_ = 0.0;     ///< mm³ by which the reported sum lags the exact one
};

/// Where shank or holder touches something.
struct ShankContact {
    bool touches = false;
    std::uint8_t piece = 0;               ///< 1 shank, 2 … holder segments
    PropertyIndex property = airProperty; ///< what is touched
    glm::dvec3 place{0.0};                ///< mm, centre of the collision area (paper, eq. 4), setup frame
    double volume = 0.0;                  ///< mm³ of overlap
};

/// Shank and holder at a tip (axis +Z) against everything in the workpiece, part and stock alike. Read only; the first
/// few run units of overlap (a quarter of a voxel) count as touching air.
ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, const glm::dvec3& tip) noexcept;

} // namespace burin
