// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <filesystem>
#include <string>

namespace burin {

struct WrittenVolume {
    std::string file, table;       ///< absolute; the table of an array's materials, or empty
    std::size_t triangles = 0;     ///< of a surface
    std::uint64_t roundedEnds = 0; ///< as WholeVoxels
};

/// Writes a volume by the suffix: .srle (volume file), .nrrd (voxel array, its table beside it), .stl, .ply, .3mf
/// (surface). What stood there stands there until the new file is whole. Any thread.
/// Errors: notSupported (another suffix), fileNotWritable, diskFull, outOfMemory, modelHasNoSolid (a surface of air),
/// cancelled.
Result<WrittenVolume> writeAnyVolume(const std::filesystem::path& file, const VolumeSnapshot& volume,
                                     Progress& progress);

} // namespace burin
