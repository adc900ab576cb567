// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <filesystem>
#include <string>

namespace burin {

struct WrittenVolume {
    std::string file, table;       ///< absolute; the table with the materials of an array, or empty
    std::size_t triangles = 0;     ///< for a surface
    std::uint64_t roundedEnds = 0; ///< see WholeVoxels
};

/// Writes a volume in the format of the suffix: .srle (volume file), .nrrd (voxel array, its table next to it), .stl,
/// .ply, .3mf (surface). An existing file is kept until the new one is complete. Thread-safe. Errors: notSupported
/// (another suffix), fileNotWritable, diskFull, outOfMemory, modelHasNoSolid (a surface of air), cancelled.
Result<WrittenVolume> writeAnyVolume(const std::filesystem::path& file, const VolumeSnapshot& volume,
                                     Progress& progress);

} // namespace burin
