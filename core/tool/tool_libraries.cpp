// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_libraries.h"

#include "core/base/clean_text.h"
#include "core/base/file.h"
#include "core/base/json_object.h"
#include "core/base/resource_folder.h"
#include "core/base/staged_file.h"
#include "core/base/trimmed.h"
#include "core/tool/tool_library.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longestName = 80; // bytes
constexpr const char* fileOfLibraries = "tool-libraries.json";

/// Empty if there is no home folder.
fs::path pathOfLibraries() {
    const fs::path tools = userResourceDirectory(toolResource);
    return tools.empty() ? fs::path() : tools.parent_path() / fileOfLibraries;
}

bool isReserved(std::string name) {
    for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return name == allTools || name == starterLibrary || name == ownLibrary;
}

Error unknownLibrary(const ToolLibraries& libraries, const std::string& name) {
    std::string known(ownLibrary);
    for (const std::string& each : libraries.names) known += ", " + each;
    return {ErrorCode::nameUnknown, "library", name, known};
}

Result<void> save(const ToolLibraries& libraries) {
    const fs::path file = pathOfLibraries();
    if (file.empty()) return Error{ErrorCode::fileNotWritable, fileOfLibraries, {}, "there is no home folder"};
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const std::string& name : libraries.names) {
        nlohmann::ordered_json tools = nlohmann::ordered_json::array();
        for (const auto& [tool, library] : libraries.ofTool)
            if (library == name) tools.push_back(tool);
        list.push_back({{"name", name}, {"tools", std::move(tools)}});
    }
    const nlohmann::ordered_json json{{"libraries", std::move(list)}};
    if (Result<void> made = makeFolderOf(file); !made) return made;
    return writeFileAtomically(file, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void addName(ToolLibraries& libraries, const std::string& name) {
    libraries.names.insert(std::ranges::upper_bound(libraries.names, name), name);
}

Result<void> checkFree(const ToolLibraries& libraries, const std::string& name) {
    if (Result<void> valid = checkLibraryName(name); !valid) return valid;
    if (!libraries.contains(name)) return {};
    return Error{ErrorCode::argumentInvalid, "library", name, "a name that no library has yet"};
}

} // namespace

bool ToolLibraries::contains(std::string_view name) const {
    return std::ranges::find(names, name) != names.end();
}

std::string ToolLibraries::libraryOf(const std::string& tool) const {
    if (isShippedTool(tool)) return std::string(starterLibrary);
    const auto found = ofTool.find(tool);
    return found == ofTool.end() ? std::string(ownLibrary) : found->second;
}

bool ToolLibraries::isIn(const std::string& tool, std::string_view library) const {
    return library == allTools || libraryOf(tool) == library;
}

Result<ToolLibraries> loadToolLibraries() {
    ToolLibraries libraries;
    const fs::path path = pathOfLibraries();
    std::error_code ignored;
    if (path.empty() || !fs::exists(path, ignored)) return libraries;
    const Result<std::string> text = readFile(path);
    if (!text) return text.error();
    Result<JsonObject> file = JsonObject::parse(*text, path.string());
    if (!file) return file.error();
    file->objects("libraries", [&](JsonObject& library) {
        const std::string name = library.text("name");
        if (libraries.contains(name)) library.fail("name", "stands twice");
        if (const Result<void> valid = checkLibraryName(name); !valid)
            library.fail("name", "has to be " + valid.error().detail);
        for (const std::string& tool : library.texts("tools")) libraries.ofTool.emplace(tool, name);
        addName(libraries, name);
    });
    if (Result<void> read = file->finish(); !read) return read.error();
    return libraries;
}

Result<void> checkLibraryName(const std::string& name) {
    if (name.empty() || trimmed(name, " ") != name || name.size() > longestName || cleanLine(name) != name ||
        isReserved(name))
        return Error{ErrorCode::argumentInvalid, "library", name,
                     "a short line of text other than all, starter and mine, without spaces around it"};
    return {};
}

Result<void> checkOwnLibrary(const ToolLibraries& libraries, const std::string& name) {
    if (name == starterLibrary || name == allTools)
        return Error{ErrorCode::argumentInvalid, "library", name, "mine, or a library of your own"};
    if (name == ownLibrary || libraries.contains(name)) return {};
    return unknownLibrary(libraries, name);
}

std::string freeLibraryName(const ToolLibraries& libraries, const std::string& name) {
    constexpr std::size_t room = 6; // for the number
    const std::string line = cleanLine(name);
    std::size_t end = std::min(line.size(), longestName - room);
    while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end; // whole characters
    std::string wanted(trimmed(std::string_view(line).substr(0, end), " "));
    if (wanted.empty()) wanted = "Tools";
    std::string free = wanted;
    for (int i = 2; libraries.contains(free) || isReserved(free); ++i) free = wanted + " " + std::to_string(i);
    return free;
}

Result<void> addToolLibrary(const std::string& name) {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    if (Result<void> free = checkFree(*libraries, name); !free) return free;
    addName(*libraries, name);
    return save(*libraries);
}

Result<void> renameToolLibrary(const std::string& from, const std::string& to) {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    if (!libraries->contains(from)) return unknownLibrary(*libraries, from);
    if (Result<void> free = checkFree(*libraries, to); !free) return free;
    std::erase(libraries->names, from);
    addName(*libraries, to);
    for (auto& [tool, library] : libraries->ofTool)
        if (library == from) library = to;
    return save(*libraries);
}

Result<void> removeToolLibrary(const std::string& name) {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    if (!libraries->contains(name)) return unknownLibrary(*libraries, name);
    std::erase(libraries->names, name);
    std::erase_if(libraries->ofTool, [&](const auto& entry) { return entry.second == name; });
    return save(*libraries);
}

Result<void> putTool(const std::string& tool, const std::string& library) {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) return libraries.error();
    if (Result<void> own = checkOwnLibrary(*libraries, library); !own) return own;
    const auto former = libraries->ofTool.find(tool);
    const std::string before = former == libraries->ofTool.end() ? std::string(ownLibrary) : former->second;
    if (before == library) return {};
    libraries->ofTool.erase(tool);
    if (library != ownLibrary) libraries->ofTool.emplace(tool, library);
    return save(*libraries);
}

} // namespace burin
