// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <filesystem>

namespace burin {

/// The kinds of files that describe a volume voxel by voxel.
enum class VolumeSource : std::uint8_t {
    volumeFile, ///< Burin's own format, core/volume/packed/volume_file.md
    voxelArray, ///< a format that readArrayFile reads
    other       ///< none of these, possibly a model
};
/// Detected from the beginning of the content. Errors: fileNotFound, fileNotReadable, fileEmpty.
Result<VolumeSource> volumeSourceOf(const std::filesystem::path& file);

struct VolumeInput {
    RunVolume volume;
    bool unitKnown = true; ///< false: the file states no unit of length, and mm were assumed
};
/// Reads a volume file, or a voxel array with the table of its materials (ids refer to the library). Thread-safe.
/// Errors: those of readVolumeFile (also for damage), readArrayFile, ArrayTable::parse, volumeOf, argumentInvalid
/// (subject "table": an array without one).
Result<VolumeInput> readAnyVolume(const std::filesystem::path& file, const std::filesystem::path& table,
                                  Progress& progress);

} // namespace burin
