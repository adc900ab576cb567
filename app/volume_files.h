// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

class CommandContext;

/// Reads a volume file, or a voxel array with the table of its materials; the kind is found from the content. A file
/// that states no unit is told. Errors: those of readVolumeFile (also its damage), readArrayFile, ArrayTable::parse,
/// volumeOf, argumentInvalid (an array without a table).
Result<RunVolume> readAnyVolume(const std::string& file, const std::string& table, CommandContext& context);

struct WrittenVolume {
    std::string file, table;       ///< absolute; the table of an array's materials, or empty
    std::size_t triangles = 0;     ///< of a surface
    std::uint64_t roundedEnds = 0; ///< as WholeVoxels
};
/// Writes a volume by the suffix. Errors: notSupported (another one), those of writing.
Result<WrittenVolume> writeAnyVolume(const std::string& file, const VolumeSnapshot& volume, CommandContext& context);

} // namespace burin
