// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/array_file.h"
#include "core/exchange/array_table.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// The voxels of an array as runs (Chen & Yang 2004, section 2): lossless, a run ends where the material changes.
/// Errors: argumentInvalid (subject: the file; place: a value that is not in the table; detail: the first voxel with
/// it), outOfMemory, volumeOutOfMemory.
Result<RunVolume> volumeOf(const VoxelArray& array, const ArrayTable& table);

/// A volume as an array: each voxel has the property at its centre.
struct WholeVoxels {
    std::vector<std::uint8_t> properties; ///< x varies fastest, then y, then z
    std::uint64_t roundedEnds = 0;        ///< number of run ends within a voxel, which were rounded
};
WholeVoxels wholeVoxels(const VolumeSnapshot& volume);

} // namespace burin
