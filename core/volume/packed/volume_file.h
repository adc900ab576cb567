// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Scanlines low.u <= u < high.u, low.v <= v < high.v that could not be restored from a damaged file; they hold air.
struct VolumeLoss {
    LineIndex low, high;
    Box box; ///< mm, setup frame: the full length of these scanlines
};

/// Content of a volume file.
struct VolumeFileContent {
    RunVolume volume;
    std::vector<VolumeLoss> lost;  ///< empty: the file was complete
    bool headerWasDamaged = false; ///< true: the header was read from its second copy
    std::string file;

    /// Returns fileDamaged, with the lost bricks and their location as the place. Empty if no brick is lost.
    std::optional<Error> damage() const;
};

/// Writes a volume in its file form (volume_file.md): packed bricks, compressed and checksummed in groups of up to 16 ×
/// 16, with the header at both ends. Written one brick group at a time, so that memory is bounded.
/// Errors: cancelled, outOfMemory (also for a single brick beyond 1 GiB), fileNotWritable, diskFull, argumentInvalid (a
/// property that its JSON form does not reproduce: one without a name, or a value that is not finite).
Result<void> writeVolume(std::ostream& stream, const std::string& name, const VolumeSnapshot& volume,
                         Progress& progress);
/// As writeVolume, to a temporary file beside `file` that is then renamed: afterwards either the complete new file or
/// the previous one is there.
Result<void> writeVolumeFile(const std::filesystem::path& file, const VolumeSnapshot& volume, Progress& progress);

/// Reads a volume, one brick group at a time. Whatever can be read from a damaged stream is restored exactly; what is
/// lost is listed and read as air.
/// @param stream  must be seekable back to its beginning
/// @param reservedBytes  of the volume; 0: twice the size of the content, plus the default for its grid
/// Errors: cancelled, fileFormatUnknown (no header of a volume found), fileDamaged (neither copy of the header can be
/// read), fileFromNewerBurin, outOfMemory, volumeOutOfMemory.
Result<VolumeFileContent> readVolume(std::istream& stream, const std::string& name, Progress& progress,
                                     std::size_t reservedBytes = 0);
/// Errors, in addition to those above: fileNotFound, fileNotReadable, fileEmpty.
Result<VolumeFileContent> readVolumeFile(const std::filesystem::path& file, Progress& progress,
                                         std::size_t reservedBytes = 0);

} // namespace burin
