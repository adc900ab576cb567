// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/volume_files.h"

#include "app/command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/exchange/array_volume.h"
#include "core/volume/packed/volume_file.h"

#include <array>
#include <filesystem>

namespace burin {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view volumeMark = "BurinVol"; // core/volume/packed/volume_file.md

Result<bool> isVolumeFile(const fs::path& file) {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    std::array<char, volumeMark.size()> head{};
    stream->read(head.data(), head.size());
    return std::string_view(head.data(), static_cast<std::size_t>(stream->gcount())) == volumeMark;
}

Result<RunVolume> readArray(const std::string& file, const std::string& table, CommandContext& context) {
    const Result<VoxelArray> array = readArrayFile(file);
    if (!array) return array.error();
    if (table.empty())
        return Error{ErrorCode::argumentInvalid,
                     "--table",
                     {},
                     worded(BURIN_TEXT("Command", "a table of what the values of the array mean"))};
    if (!array->unitKnown)
        context.message(worded(BURIN_TEXT("Command", "%1 states no unit of length: mm are taken."), {file}));
    const Result<std::string> text = readFile(table);
    if (!text) return text.error();
    const Result<ArrayTable> parsed =
        ArrayTable::parse(*text, table, [](const std::string& id) { return loadMaterial(id); });
    if (!parsed) return parsed.error();
    return volumeOf(*array, *parsed);
}

} // namespace

Result<RunVolume> readAnyVolume(const std::string& file, const std::string& table, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Reading"));
    const Result<bool> own = isVolumeFile(file);
    if (!own) return own.error();
    if (!*own) return readArray(file, table, context);
    Result<VolumeFileContent> content = readVolumeFile(file, context.progress());
    if (!content) return std::move(content).error();
    if (const std::optional<Error> damage = content->damage()) return *damage;
    return std::move(content->volume);
}

} // namespace burin
