// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// The last scanlines of a stock whose width is no whole number of voxels: they stand for more or less of it than one
/// voxel. What is removed of them is counted by what they stand for.
class SideLines {
public:
    /// Before anything is removed. @param stock mm, setup frame
    SideLines(const RunVolume& workpiece, const Box& stock);

    /// mm³ by which what was removed since is more than its scanlines say, a voxel wide each; may be negative.
    double removedBeside(const RunVolume& workpiece) const;

private:
    struct Line {
        LineIndex line;
        double beside = 0.0;     ///< what it stands for, less 1
        std::uint64_t units = 0; ///< machinable, then
    };
    std::vector<Line> lines_;
};

} // namespace burin
