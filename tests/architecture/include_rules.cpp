// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

/// The headers that a plugin may include in addition to its own.
constexpr std::array<std::string_view, 20> pluginInterface{
    "core/base/mailbox.h",         "core/base/error.h",          "core/base/progress.h",
    "core/base/result.h",          "core/base/text.h",           "core/base/units.h",
    "core/device/assist.h",        "core/device/axis_map.h",     "core/device/deflection.h",
    "core/device/device_driver.h", "core/device/device_fault.h", "core/device/device_thread.h",
    "core/device/driver_thread.h", "core/device/figure.h",       "core/device/stylus.h",
    "core/geometry/box.h",         "core/geometry/pose.h",       "core/machine/machine_profile.h",
    "core/nc/dialect.h",           "core/nc/program.h"};

/// Folders that others use unchanged outside our tree: their files include each other by file name only.
constexpr std::array<std::string_view, 1> handedOut{"plugins/devices/open_stylus/firmware"};

/// Code shared by the plugins of one kind and built into each of them.
constexpr std::array<std::string_view, 4> sharedByPlugins{"plugins/devices/cap", "plugins/devices/hid",
                                                          "plugins/devices/polled", "plugins/devices/vendor"};

/// A third-party library; core/README.md says who may include it.
struct Foreign {
    std::string_view name;
    bool (*owns)(std::string_view header);
};

bool isQt(std::string_view header) {
    return header.size() > 1 && header[0] == 'Q' &&
           (std::isupper(static_cast<unsigned char>(header[1])) != 0 || header.starts_with("Qt"));
}
bool isVtk(std::string_view header) {
    return header.starts_with("vtk");
}
bool isOcct(std::string_view header) {
    return header.ends_with(".hxx") || header.ends_with(".lxx");
}
bool isHidapi(std::string_view header) {
    return header.starts_with("hidapi");
}
bool isSystemd(std::string_view header) {
    return header.starts_with("systemd/");
}
bool isMuParser(std::string_view header) {
    return header.starts_with("muParser");
}
bool isYaml(std::string_view header) {
    return header.starts_with("yaml-cpp/");
}
bool isAssimp(std::string_view header) {
    return header.starts_with("assimp/");
}
bool isZlib(std::string_view header) {
    return header == "zlib.h";
}
bool isLibzip(std::string_view header) {
    return header == "zip.h";
}
bool isClipper(std::string_view header) {
    return header.starts_with("polyclipping/");
}
bool isPugixml(std::string_view header) {
    return header == "pugixml.hpp";
}
bool isSqlite(std::string_view header) {
    return header.starts_with("sqlite3");
}

constexpr std::array<Foreign, 13> foreigners{Foreign{"Qt", isQt},
                                             Foreign{"VTK", isVtk},
                                             Foreign{"OpenCASCADE", isOcct},
                                             Foreign{"SQLite", isSqlite},
                                             Foreign{"hidapi", isHidapi},
                                             Foreign{"libsystemd", isSystemd},
                                             Foreign{"muParser", isMuParser},
                                             Foreign{"yaml-cpp", isYaml},
                                             Foreign{"assimp", isAssimp},
                                             Foreign{"zlib", isZlib},
                                             Foreign{"libzip", isLibzip},
                                             Foreign{"pugixml", isPugixml},
                                             Foreign{"Clipper", isClipper}};

bool allowed(const Arrows& arrows, const std::string& library, const std::string& header, const std::string& source) {
    if (library == "plugins")
        return std::ranges::find(pluginInterface, header) != pluginInterface.end() ||
               firstParts(header, 3) == firstParts(source, 3) ||
               (firstParts(header, 2) == firstParts(source, 2) &&
                std::ranges::find(sharedByPlugins, firstParts(header, 3)) != sharedByPlugins.end());
    return arrows.allow(library, libraryOf(header));
}

bool isOurs(std::string_view header) {
    return header.starts_with("core/") || header.starts_with("ui/") || header.starts_with("app/") ||
           header.starts_with("plugins/") || header.starts_with("tests/");
}

std::string foreignFault(const Arrows& arrows, const std::string& library, const std::string& header) {
    for (const Foreign& foreign : foreigners)
        if (foreign.owns(header) && !arrows.allowForeign(library, foreign.name))
            return library + " may not include " + std::string(foreign.name);
    return {};
}

/// The fault of one include; empty if there is none.
std::string faultOf(const Arrows& arrows, const std::string& source, const std::string& include) {
    const std::string library = libraryOf(source), header = include.substr(1);
    if (include.starts_with('<')) return foreignFault(arrows, library, header);
    if (header.ends_with(".moc")) return {};
    const fs::path folder = fs::path(source).parent_path();
    if (std::ranges::find(handedOut, folder.generic_string()) != handedOut.end())
        return header.find('/') == std::string::npos ? std::string() : "what is handed out stands alone";
    if (!isOurs(header)) return "our headers are named from the root";
    return allowed(arrows, library, header, source) ? std::string() : library + " may not use " + libraryOf(header);
}

bool isCode(const fs::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".h" || ending == ".cpp" || ending == ".c" || ending == ".hpp";
}

void checkFile(const Arrows& arrows, const fs::path& root, const fs::path& file, std::vector<std::string>& faults) {
    const std::string source = fs::relative(file, root).generic_string();
    if (!arrows.knows(libraryOf(source)))
        faults.push_back(source + ": " + libraryOf(source) + " has no row in core/README.md");
    std::ifstream stream(file);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::string include = includedBy(line);
        const std::string fault = include.empty() ? std::string() : faultOf(arrows, source, include);
        if (!fault.empty()) faults.push_back(source + ":" + std::to_string(number) + ": " + fault);
    }
}

} // namespace

std::string includedBy(std::string_view line) {
    const auto skipSpace = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
    skipSpace();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skipSpace();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(std::string_view("include").size());
    skipSpace();
    if (!line.starts_with('"') && !line.starts_with('<')) return {};
    return std::string(line.substr(0, line.find_first_of("\">", 1)));
}

std::vector<std::string> forbiddenIncludes(const fs::path& root, const Arrows& arrows) {
    std::vector<std::string> faults;
    for (const char* folder : {"core", "ui", "app", "plugins"}) {
        if (!fs::exists(root / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file() && isCode(entry.path())) checkFile(arrows, root, entry.path(), faults);
    }
    std::ranges::sort(faults);
    return faults;
}

std::vector<std::string> watchedForeignLibraries() {
    std::vector<std::string> names;
    for (const Foreign& foreign : foreigners) names.emplace_back(foreign.name);
    std::ranges::sort(names);
    return names;
}

} // namespace burin::architecture
