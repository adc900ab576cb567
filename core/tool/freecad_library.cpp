// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// FreeCAD's tool libraries: src/Mod/CAM/Path/Tool/library/serializers/fctl.py of its sources.
#include "core/base/file.h"
#include "core/base/resource_folder.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <set>

namespace burin {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr const char* bitFolder = "Bit";
constexpr const char* libraryFolder = "Library"; // FreeCAD's name for the folder next to that of the bits

/// Returns the paths where FreeCAD looks for a bit, except its own store.
std::vector<fs::path> placesOf(const fs::path& library, const std::string& bit) {
    const fs::path folder = library.parent_path(), name = fs::path(bit).filename();
    return {folder / name, folder / bitFolder / name, folder.parent_path() / bitFolder / name};
}

/// @param library absolute
bool isInLibraryFolder(const fs::path& library) {
    return library.parent_path().filename() == libraryFolder;
}

/// Chooses the files of bits. A file that another library may use is never replaced by a different one.
class BitFiles {
public:
    /// @param library absolute
    explicit BitFiles(const fs::path& library)
        : folder_(isInLibraryFolder(library) ? library.parent_path().parent_path() / bitFolder
                                             : library.parent_path() / bitFolder) {
        const Result<std::string> former = readFile(library);
        const json old = former ? json::parse(*former, nullptr, false) : json();
        if (isFreecadLibrary(old))
            for (const json& entry : old["tools"]) own_.insert(fs::path(entry["path"].get<std::string>()).filename());
    }

    fs::path fileFor(const std::string& id, const std::string& text) {
        const auto taken = [&](const std::string& stem) {
            const std::string name = stem + ".fctb";
            if (used_.contains(name)) return true;
            std::error_code unreached;
            if (own_.contains(name) || !fs::exists(folder_ / name, unreached)) return false;
            const Result<std::string> present = readFile(folder_ / name);
            return !present || *present != text;
        };
        const std::string name = freeResourceId(id, taken) + ".fctb";
        used_.insert(name);
        return folder_ / name;
    }

private:
    fs::path folder_;
    std::set<std::string> own_; ///< names of the bits of the library that is replaced
    std::set<std::string> used_;
};

} // namespace

bool isFreecadLibrary(const json& file) {
    if (!file.is_object() || !file.contains("tools") || !file["tools"].is_array()) return false;
    return std::ranges::all_of(file["tools"], [](const json& entry) {
        return entry.is_object() && entry.contains("path") && entry["path"].is_string();
    });
}

Result<ReadTools> readFreecadLibrary(const json& library, const fs::path& file, const Tool& like) {
    ReadTools read;
    for (const json& entry : library["tools"]) {
        const std::string bit = entry["path"].get<std::string>();
        std::error_code unreached;
        const auto places = placesOf(file, bit);
        const auto place = std::ranges::find_if(places, [&](const auto& at) { return fs::exists(at, unreached); });
        if (place == places.end()) {
            read.leftOut.push_back(bit + ": the tool bit was not found next to the library.");
            continue;
        }
        const Result<std::string> text = readFile(*place);
        Result<ReadTool> tool = text ? toolFromText(*text, place->string(), like) : Result<ReadTool>(text.error());
        if (!tool) {
            read.leftOut.push_back(bit + ": " + tool.error().place + " " + tool.error().detail + ".");
            continue;
        }
        if (const auto number = entry.find("nr"); number != entry.end() && number->is_number_integer())
            tool->tool.number = wholeNumberOf(*number);
        if (Result<Tool> sound = toolFromJson(toJson(tool->tool), bit); !sound) {
            read.leftOut.push_back(bit + ": " + sound.error().place + " " + sound.error().detail + ".");
            continue;
        }
        read.tools.push_back(std::move(*tool));
    }
    return read;
}

Result<WrittenTools> freecadLibrary(const fs::path& file, const std::vector<Tool>& tools) {
    WrittenTools written;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::set<int> numbers;
    std::set<std::string> notes;
    std::error_code unknown;
    const fs::path whole = fs::absolute(file, unknown);
    BitFiles bits(whole);
    for (const Tool& tool : tools) {
        const Result<WrittenTools> bit = freecadBit(tool);
        if (!bit) {
            written.notes.push_back(tool.id + ": FreeCAD does not support this shape.");
            continue;
        }
        if (!numbers.insert(tool.number).second)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, std::to_string(tool.number),
                         "a number that no other tool has"};
        const fs::path place = bits.fileFor(tool.id, bit->text);
        written.files.push_back({place, bit->text});
        list.push_back({{"nr", tool.number}, {"path", place.filename().string()}});
        notes.insert(bit->notes.begin(), bit->notes.end());
    }
    if (list.empty()) return Error{ErrorCode::notSupported, "a FreeCAD tool library of these tools", "other forms", ""};
    const nlohmann::ordered_json library{{"version", 1}, {"label", file.stem().string()}, {"tools", std::move(list)}};
    written.text = library.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    notes.erase(lostInBit); // the library has the numbers
    written.notes.insert(written.notes.end(), notes.begin(), notes.end());
    written.notes.emplace_back("Holders and limits can't be stored in a FreeCAD library and were left out.");
    if (!isInLibraryFolder(whole))
        written.notes.emplace_back("The bits are in the folder Bit next to the library. FreeCAD finds them if the "
                                   "library itself is in a folder Library next to that folder.");
    return written;
}

} // namespace burin
