// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <filesystem>

namespace burin {

/// What describes a volume voxel by voxel.
enum class VolumeSource : std::uint8_t {
    volumeFile, ///< Burin's own, core/volume/packed/volume_file.md
    voxelArray, ///< what readArrayFile reads
    other       ///< neither; a model, perhaps
};
/// Found from the beginning of the content. Errors: fileNotFound, fileNotReadable, fileEmpty.
Result<VolumeSource> volumeSourceOf(const std::filesystem::path& file);

struct VolumeInput {
    RunVolume volume;
    bool unitKnown = true; ///< false: the file states no unit of length, and mm were taken
};
/// Reads a volume file, or a voxel array with the table of its materials (those named by their ids are the library's).
/// Any thread. Errors: those of readVolumeFile (also its damage), readArrayFile, ArrayTable::parse, volumeOf,
/// argumentInvalid (subject "table": an array without one).
Result<VolumeInput> readAnyVolume(const std::filesystem::path& file, const std::filesystem::path& table,
                                  Progress& progress);

} // namespace burin
