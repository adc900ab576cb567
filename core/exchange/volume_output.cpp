// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/volume_output.h"

#include "core/base/staged_file.h"
#include "core/base/steps.h"
#include "core/exchange/array_volume.h"
#include "core/exchange/surface_file.h"
#include "core/volume/packed/volume_file.h"

namespace burin {

namespace {

namespace fs = std::filesystem;

/// Writes the array and its table: both or neither.
Result<WrittenVolume> writeArray(const fs::path& file, const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    const WholeVoxels whole = wholeVoxels(volume);
    fs::path table = file;
    table.replace_extension(".table.json");
    Result<StagedFile> values =
        StagedFile::containing(file, nrrdOf(grid.count(), grid.edge(), grid.low(), whole.properties));
    if (!values) return std::move(values).error();
    Result<StagedFile> entries = StagedFile::containing(table, tableOf(volume.properties()));
    if (!entries) return std::move(entries).error();
    const Result<void> placed = inOrder([&] { return values->keepPrevious(); }, [&] { return entries->keepPrevious(); },
                                        [&] { return values->putInPlace(); }, [&] { return entries->putInPlace(); });
    if (!placed) {
        values->takeBack();
        return placed.error();
    }
    return WrittenVolume{{}, fs::absolute(table).lexically_normal().string(), 0, whole.roundedEnds};
}

Result<WrittenVolume> writeSurface(const fs::path& file, const VolumeSnapshot& volume, Progress& progress) {
    const Result<VolumeSurface> surface = surfaceOf(volume, progress);
    if (!surface) return surface.error();
    if (Result<void> written = writeSurfaceFile(file, *surface, volume.properties()); !written)
        return std::move(written).error();
    WrittenVolume written;
    written.triangles = surface->mesh.triangles.size();
    return written;
}

} // namespace

Result<WrittenVolume> writeAnyVolume(const fs::path& path, const VolumeSnapshot& volume, Progress& progress) {
    Result<WrittenVolume> written = [&]() -> Result<WrittenVolume> {
        if (isSurfaceFile(path)) return writeSurface(path, volume, progress);
        if (path.extension() == ".nrrd") return writeArray(path, volume);
        if (path.extension() != ".srle")
            return Error{ErrorCode::notSupported,
                         "a volume as " + path.extension().string(),
                         ".srle, .nrrd, .stl, .ply or .3mf",
                         {}};
        if (Result<void> done = writeVolumeFile(path, volume, progress); !done) return std::move(done).error();
        return WrittenVolume{};
    }();
    if (written) written->file = fs::absolute(path).lexically_normal().string();
    return written;
}

} // namespace burin
