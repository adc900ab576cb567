// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

/// A call of burin_library in a CMakeLists.txt.
struct Declared {
    std::string room;                ///< that the file belongs to: "core/cad"
    std::string name;                ///< "cad_reader"
    std::vector<std::string> linked; ///< libraries of Burin: "geometry"
};

bool isNameEnd(char c) {
    return c == ' ' || c == ')' || c == '\n' || c == ';' || c == '"';
}

std::string nameAt(const std::string& text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && !isNameEnd(text[end])) ++end;
    return text.substr(from, end - from);
}

std::vector<Declared> declaredIn(const fs::path& root, const fs::path& file) {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::string room = libraryOf(fs::relative(file, root).generic_string());
    constexpr std::string_view call = "burin_library(", link = "burin::";
    std::vector<Declared> declared;
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
        Declared library{room, nameAt(text, at + call.size()), {}};
        const std::string body = text.substr(at, text.find(')', at) - at);
        for (std::size_t used = body.find(link); used != std::string::npos; used = body.find(link, used + 1))
            library.linked.push_back(nameAt(body, used + link.size()));
        declared.push_back(std::move(library));
    }
    return declared;
}

} // namespace

std::vector<std::string> forbiddenLinks(const fs::path& root, const Arrows& arrows) {
    std::vector<Declared> libraries;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "core"))
        if (entry.path().filename() == "CMakeLists.txt")
            std::ranges::move(declaredIn(root, entry.path()), std::back_inserter(libraries));
    std::map<std::string, std::string> rooms; // by library
    for (const Declared& library : libraries) rooms[library.name] = library.room;
    std::vector<std::string> faults;
    for (const Declared& library : libraries)
        for (const std::string& linked : library.linked) {
            const auto room = rooms.find(linked);
            if (room == rooms.end() || !arrows.allow(library.room, room->second))
                faults.push_back(library.room + ": burin::" + library.name + " may not link burin::" + linked);
        }
    std::ranges::sort(faults);
    return faults;
}

} // namespace burin::architecture
