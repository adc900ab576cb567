// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/page_rules.h"

#include "tests/architecture/arrows.h"
#include "tests/architecture/page_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 8> topFolders{"app",       "cmake", "core",         "plugins",
                                                     "resources", "tests", "translations", "ui"};
/// Pages of GRBL and of 3D mice that our comments cite as their sources.
constexpr std::array<std::string_view, 5> pagesOfOthers{"doc/markdown/commands.md", "doc/markdown/interface.md",
                                                        "commands.md", "SpaceNavigator.md", "SpaceMouseWireless.md"};
/// Lists sources by their paths without an ending, which another test checks.
constexpr std::string_view tableOfSources = "tests/architecture/unreached_sources.md";

bool isSourceName(std::string_view name) {
    return name.ends_with(".h") || name.ends_with(".cpp");
}

bool isPlainPath(std::string_view text) {
    return std::ranges::all_of(text, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.' || c == '/';
    });
}

/// Finds references of a page to missing files. @param names of all sources, without their folders
void checkPage(const fs::path& root, const std::string& page, const std::set<std::string>& names,
               std::vector<std::string>& faults) {
    std::ifstream stream(root / page);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        for (const std::string& quoted : quotedIn(line)) {
            const std::string name = quoted.substr(0, quoted.find(' '));
            if (!isPlainPath(name)) continue;
            const bool ofOurs = name.find('/') != std::string::npos &&
                                std::ranges::find(topFolders, firstParts(name, 1)) != topFolders.end();
            const bool bare = name.find('/') == std::string::npos && isSourceName(name);
            const bool found = ofOurs ? fs::exists(root / name) : !bare || names.contains(name);
            if (!found) faults.push_back(page + ":" + std::to_string(number) + ": there is no " + name);
        }
    }
}

/// Finds pages that a source's comments name and that do not exist. @param names of all our pages, without their
/// folders
void checkSource(const fs::path& root, const std::string& source, const std::set<std::string>& names,
                 std::vector<std::string>& faults) {
    constexpr std::string_view ending = ".md";
    std::ifstream stream(root / source);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        const std::size_t comment = line.find("//");
        if (comment == std::string::npos) continue;
        for (std::size_t at = line.find(ending, comment); at != std::string::npos; at = line.find(ending, at + 1)) {
            std::size_t begin = at;
            while (begin > 0 && isPlainPath({&line[begin - 1], 1})) --begin;
            const std::string page = line.substr(begin, at + ending.size() - begin);
            const bool found = fs::exists(root / page) || names.contains(page) ||
                               std::ranges::find(pagesOfOthers, page) != pagesOfOthers.end();
            if (begin < at && !found) faults.push_back(source + ":" + std::to_string(number) + ": there is no " + page);
        }
    }
}

} // namespace

std::vector<std::string> deadReferences(const fs::path& root, const std::vector<std::string>& files) {
    std::set<std::string> sources, pages; // without their folders
    for (const std::string& file : files) {
        const std::string name = fs::path(file).filename().string();
        if (isSourceName(file)) sources.insert(name);
        if (file.ends_with(".md")) pages.insert(name);
    }
    std::vector<std::string> faults;
    for (const std::string& file : files)
        if (file.starts_with("tests/fixtures/") || file == tableOfSources)
            continue;
        else if (file.ends_with(".md"))
            checkPage(root, file, sources, faults);
        else if (isSourceName(file))
            checkSource(root, file, pages, faults);
    return faults;
}

} // namespace burin::architecture
