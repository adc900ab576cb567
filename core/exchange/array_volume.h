// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/array_file.h"
#include "core/exchange/array_table.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// The voxels of an array as runs (Chen & Yang 2004, section 2): lossless, a run ends where the material changes.
/// Errors: argumentInvalid (subject: the file; place: a value that the table does not know; detail: the first voxel of
/// it), outOfMemory, volumeOutOfMemory.
Result<RunVolume> volumeOf(const VoxelArray& array, const ArrayTable& table);

/// A volume as an array: each voxel the property that its centre lies in.
struct WholeVoxels {
    std::vector<std::uint8_t> properties; ///< x counts fastest, then y, then z
    std::uint64_t roundedEnds = 0;        ///< run ends that lay within a voxel: what was lost
};
WholeVoxels wholeVoxels(const VolumeSnapshot& volume);

} // namespace burin
