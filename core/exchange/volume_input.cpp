// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/volume_input.h"

#include "core/base/file.h"
#include "core/exchange/array_volume.h"
#include "core/volume/packed/volume_file.h"

#include <array>
#include <string>

namespace burin {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view volumeMark = "BurinVol"; // core/volume/packed/volume_file.md
constexpr std::string_view nrrdMark = "NRRD", jsonMark = "{";

Result<VolumeInput> readArrayWithTable(const fs::path& file, const fs::path& table) {
    const Result<VoxelArray> array = readArrayFile(file);
    if (!array) return array.error();
    if (table.empty())
        return Error{ErrorCode::argumentInvalid, "table", file.string(),
                     "a table of what the values of the array mean"};
    const Result<std::string> text = readFile(table);
    if (!text) return text.error();
    const Result<ArrayTable> parsed =
        ArrayTable::parse(*text, table.string(), [](const std::string& id) { return loadMaterial(id); });
    if (!parsed) return parsed.error();
    Result<RunVolume> volume = volumeOf(*array, *parsed);
    if (!volume) return std::move(volume).error();
    return VolumeInput{std::move(*volume), array->unitKnown};
}

} // namespace

Result<VolumeSource> volumeSourceOf(const fs::path& file) {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    std::array<char, volumeMark.size()> head{};
    stream->read(head.data(), head.size());
    const std::string_view begin(head.data(), static_cast<std::size_t>(stream->gcount()));
    if (begin.empty()) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    if (begin == volumeMark) return VolumeSource::volumeFile;
    const bool array = begin.starts_with(nrrdMark) || begin.starts_with(jsonMark);
    return array ? VolumeSource::voxelArray : VolumeSource::other;
}

Result<VolumeInput> readAnyVolume(const fs::path& file, const fs::path& table, Progress& progress) {
    const Result<VolumeSource> source = volumeSourceOf(file);
    if (!source) return source.error();
    if (*source != VolumeSource::volumeFile) return readArrayWithTable(file, table);
    Result<VolumeFileContent> content = readVolumeFile(file, progress);
    if (!content) return std::move(content).error();
    if (const std::optional<Error> damage = content->damage()) return *damage;
    return VolumeInput{std::move(content->volume)};
}

} // namespace burin
