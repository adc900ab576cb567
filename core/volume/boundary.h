// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/run_volume.h"

#include <vector>

namespace burin {

/// Neighbouring voxels first … last (inclusive) of one scanline.
struct VoxelStretch {
    std::int32_t first = 0, last = 0;
    friend bool operator==(VoxelStretch, VoxelStretch) = default;
};

/// Boundary voxels of one scanline, in order: voxels of the object with at least one empty voxel among their 26
/// neighbours (Chen & Yang 2004, eq. 2, by the run criteria of section 4.2). Beyond the grid everything is empty.
/// Cost: runs of the line and of its eight neighbours.
std::vector<VoxelStretch> boundaryOfLine(const VolumeSnapshot& volume, LineIndex line);

/// All boundary voxels, by scanlines (v, then u), then along them. Parallel.
std::vector<VoxelIndex> boundaryVoxels(const VolumeSnapshot& volume);

} // namespace burin
