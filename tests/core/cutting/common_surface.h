// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin::tests {

/// Eq. 4 of the paper by examining every voxel: surface voxels of a workpiece that are also surface voxels of the body
/// that `holds` describes (called with i, j, k, also for one voxel around the grid), ordered by scanlines, then along
/// them.
template <class Holds>
std::vector<VoxelIndex> commonSurface(const RunVolume& workpiece, const Holds& holds) {
    const Grid& grid = workpiece.grid();
    const auto belongs = [&](int i, int j, int k) {
        return grid.contains(VoxelIndex{i, j, k}) && workpiece.belongs({i, j, k});
    };
    const auto onSurface = [](const auto& object, VoxelIndex at) {
        if (!object(at.i, at.j, at.k)) return false;
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = -1; c <= 1; ++c)
                    if (!object(at.i + a, at.j + b, at.k + c)) return true;
        return false;
    };
    std::vector<VoxelIndex> common;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (std::int32_t k = 0; k < grid.voxelsPerLine(); ++k)
                if (const VoxelIndex voxel = grid.voxel(line, k); onSurface(holds, voxel) && onSurface(belongs, voxel))
                    common.push_back(voxel);
    return common;
}

} // namespace burin::tests
