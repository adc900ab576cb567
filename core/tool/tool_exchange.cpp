// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_exchange.h"

#include "core/base/file.h"
#include "core/base/resource_folder.h"
#include "core/base/staged_file.h"
#include "core/base/zip_archive.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace burin {

namespace {

using nlohmann::json;

constexpr std::size_t mostUnpacked = 256U << 20U; // bytes of JSON: far beyond any library

/// Adds a number to ids that occur twice.
void makeIdsUnique(ReadTools& read) {
    std::set<std::string> ids;
    for (ReadTool& tool : read.tools)
        tool.tool.id = freeResourceId(tool.tool.id, [&ids](const std::string& id) { return !ids.insert(id).second; });
}

Result<ReadTools> checked(Result<ReadTools> read) {
    if (!read) return read;
    makeIdsUnique(*read);
    if (!read->tools.empty()) return read;
    const std::string why = read->leftOut.empty() ? std::string("it holds none") : read->leftOut.front();
    return Error{ErrorCode::notSupported, "any of its tools", "another library (" + why + ")", ""};
}

Result<ReadTools> one(Result<ReadTool> tool) {
    if (!tool) return std::move(tool).error();
    ReadTools read;
    read.tools.push_back(std::move(*tool));
    return read;
}

Result<WrittenTools> oneTool(const std::string& suffix, const std::string& id, const std::vector<Tool>& tools) {
    const auto tool = std::ranges::find(tools, id, &Tool::id);
    if (tool == tools.end())
        return Error{ErrorCode::argumentInvalid, "tools", id, "one; several go into *.fctl, *.tbl, *.tools or *.ctbl"};
    if (suffix == ".fctb") return freecadBit(*tool);
    return WrittenTools{toJson(*tool), {}, {}};
}

} // namespace

Result<ReadTool> soundTool(ReadTool read, const std::string& origin, const Tool& like) {
    Tool& tool = read.tool;
    tool.id = resourceIdFrom(tool.name);
    if (tool.id.empty()) tool.id = "tool-" + std::to_string(tool.number);
    tool.maximumDepthOfCut =
        std::min(tool.cutter.fluteLength, std::max(tool.maximumDepthOfCut, like.maximumDepthOfCut));
    keepSoundPresets(read);
    if (Result<Tool> sound = toolFromJson(toJson(tool), origin); !sound) return sound.error();
    return read;
}

int wholeNumberOf(const json& value) {
    constexpr std::int64_t most = 1'000'000'000;
    return static_cast<int>(std::clamp(value.get<std::int64_t>(), -most, most));
}

Result<ReadTools> toolsFromText(std::string_view content, const std::string& origin, const Tool& like, double unit) {
    std::optional<std::string> unpacked;
    if (content.starts_with("PK\x03\x04")) {
        unpacked = unzippedFile(content, ".json", mostUnpacked);
        if (!unpacked) return Error{ErrorCode::fileDamaged, origin, {}, "the archive can't be unpacked"};
        content = *unpacked;
    }
    const json file = json::parse(content, nullptr, false);
    if (file.is_object() && file.contains("data") && file["data"].is_array())
        return checked(readFusion(file, origin, like));
    if (isCamoticsTable(file)) return checked(readCamotics(file, origin, like));
    if (file.is_object() && file.contains("tools") && isCamoticsTable(file["tools"]))
        return checked(readCamotics(file["tools"], origin, like));
    if (file.is_discarded() && isLinuxcncTable(content)) return checked(readLinuxcnc(content, origin, like, unit));
    return one(toolFromText(content, origin, like));
}

Result<ReadTools> toolsFromFile(const std::filesystem::path& file, const Tool& like, double unit) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const json library = json::parse(*text, nullptr, false);
    if (isFreecadLibrary(library)) return checked(readFreecadLibrary(library, file, like));
    return toolsFromText(*text, file.string(), like, unit);
}

Result<WrittenTools> toolsFor(const std::string& file, const std::string& id, const std::vector<Tool>& tools,
                              double unit) {
    const std::string suffix = std::filesystem::path(file).extension().string();
    if (suffix == ".tbl") return linuxcncTable(tools, unit);
    if (suffix == ".tools") return fusionLibrary(tools);
    if (suffix == ".ctbl") return camoticsTable(tools);
    if (suffix == ".fctl") return freecadLibrary(file, tools);
    if (suffix == ".fctb" || suffix == ".json") return oneTool(suffix, id, tools);
    return Error{ErrorCode::argumentInvalid, "name of the file", file,
                 "*.fctl, *.fctb, *.tbl, *.tools, *.ctbl or *.json"};
}

Result<void> writeTools(const std::filesystem::path& file, const WrittenTools& written) {
    if (written.files.empty()) return writeFileAtomically(file, written.text);
    std::vector<StagedFile> staged;
    const auto add = [&](const std::filesystem::path& each, const std::string& text) -> Result<void> {
        if (Result<void> made = makeFolderOf(each); !made) return made;
        Result<StagedFile> output = StagedFile::containing(each, text);
        if (!output) return std::move(output).error();
        staged.push_back(std::move(*output));
        return {};
    };
    for (const WrittenTools::File& each : written.files)
        if (Result<void> done = add(each.file, each.text); !done) return done;
    if (Result<void> done = add(file, written.text); !done) return done; // its folder "Library" may not exist yet
    return putInPlace(staged);
}

} // namespace burin
