// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Corrects for the last scanlines of a stock whose width is not a whole number of voxels: they represent more or less
/// stock than one voxel. Removal from them is counted by what they represent.
class SideLines {
public:
    /// To be constructed before anything is removed. @param stock mm, setup frame
    SideLines(const RunVolume& workpiece, const Box& stock);

    /// Volume, mm³, by which the actual removal since construction exceeds that of its scanlines at a width of one
    /// voxel each; may be negative.
    double removedBeside(const RunVolume& workpiece) const;

private:
    struct Line {
        LineIndex line;
        double beside = 0.0;     ///< width in voxels that it represents, minus 1
        std::uint64_t units = 0; ///< machinable at construction
    };
    std::vector<Line> lines_;
};

} // namespace burin
