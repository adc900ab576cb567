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

/// Scanlines low.u <= u < high.u, low.v <= v < high.v that a damaged file could not give back; they hold air.
struct VolumeLoss {
    LineIndex low, high;
    Box box; ///< mm, setup frame: these scanlines from end to end
};

/// What a file of a volume held.
struct VolumeFileContent {
    RunVolume volume;
    std::vector<VolumeLoss> lost;  ///< empty: the file was whole
    bool headerWasDamaged = false; ///< and read from its second copy
    std::string file;

    /// fileDamaged; the place says which bricks are lost and where they lie. Nothing when no brick is.
    std::optional<Error> damage() const;
};

/// Writes a volume in its file form (volume_file.md): packed bricks, compressed and checksummed in groups of up to 16 ×
/// 16, the header at both ends. Brick group by brick group, so that memory stays bounded.
/// Errors: cancelled, outOfMemory (also a single brick beyond 1 GiB), fileNotWritable, diskFull, argumentInvalid (a
/// property that does not come back from its JSON form: one without a name, a value that is not finite).
Result<void> writeVolume(std::ostream& stream, const std::string& name, const VolumeSnapshot& volume,
                         Progress& progress);
/// The same beside `file`, and renames it over: afterwards the new file stands there whole, or what stood there before.
Result<void> writeVolumeFile(const std::filesystem::path& file, const VolumeSnapshot& volume, Progress& progress);

/// Reads a volume, brick group by brick group. Whatever a damaged stream still holds is given back, exactly; what is
/// lost is listed and reads as air.
/// @param stream must allow to go back to its beginning
/// @param reservedBytes of the volume; 0: what the content takes twice, and the default for its grid
/// Errors: cancelled, fileFormatUnknown (no volume's header in it), fileDamaged (neither copy of the header can be
/// read), fileFromNewerBurin, outOfMemory, volumeOutOfMemory.
Result<VolumeFileContent> readVolume(std::istream& stream, const std::string& name, Progress& progress,
                                     std::size_t reservedBytes = 0);
/// Errors, beside those above: fileNotFound, fileNotReadable, fileEmpty.
Result<VolumeFileContent> readVolumeFile(const std::filesystem::path& file, Progress& progress,
                                         std::size_t reservedBytes = 0);

} // namespace burin
