// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

/// Which libraries each one uses; through them it may use what they use. A folder that is not here is not in the
/// design. "core" stands for all of core, "ui" for all of ui.
const std::map<std::string, std::vector<std::string>, std::less<>> uses{
    {"core/base", {}},
    {"core/geometry", {"core/base"}},
    {"core/volume", {"core/geometry"}},
    {"core/cad", {"core/geometry"}},
    {"core/field", {"core/geometry"}},
    {"core/tool", {"core/geometry"}},
    {"core/machine", {"core/geometry"}},
    {"core/device", {"core/geometry"}},
    {"core/recording", {"core/device"}},
    {"core/setup", {"core/volume", "core/cad", "core/tool"}},
    {"core/cutting", {"core/volume", "core/tool"}},
    {"core/passes", {"core/cutting", "core/field", "core/setup", "core/machine", "core/recording"}},
    {"core/haptics", {"core/passes"}},
    {"core/path", {"core/recording", "core/cutting", "core/field", "core/setup", "core/machine"}},
    {"core/nc", {"core/path"}},
    {"core/verify", {"core/nc"}},
    {"core/document", {"core/nc"}},
    {"core/job", {"core/document", "core/verify", "core/haptics"}},
    {"ui/messages", {"core"}},
    {"ui/theme", {"core", "ui/messages"}},
    {"ui/scene", {"core", "ui/messages", "ui/theme"}},
    {"ui/input", {"core", "ui/messages", "ui/scene"}},
    {"ui/panels", {"core", "ui/messages", "ui/theme"}},
    {"ui/dialogs", {"core", "ui/messages", "ui/theme"}},
    {"ui/help", {"core", "ui/messages", "ui/theme", "ui/panels"}},
    {"ui/workbench", {"core", "ui/messages", "ui/input"}},
    {"ui/actions", {"core", "ui/messages", "ui/workbench"}},
    {"ui/window", {"core", "ui"}},
    {"app", {"core", "ui"}},
    {"plugins", {}},
};

/// The headers that a plugin stands on, beside its own.
constexpr std::array<std::string_view, 15> pluginInterface{"core/base/error.h",
                                                           "core/base/progress.h",
                                                           "core/base/result.h",
                                                           "core/base/text.h",
                                                           "core/base/units.h",
                                                           "core/device/deflection.h",
                                                           "core/device/device_driver.h",
                                                           "core/device/device_fault.h",
                                                           "core/device/figure.h",
                                                           "core/device/stylus.h",
                                                           "core/geometry/box.h",
                                                           "core/geometry/pose.h",
                                                           "core/machine/machine_profile.h",
                                                           "core/nc/dialect.h",
                                                           "core/nc/program.h"};

/// What others take as it is, without our tree: its files name each other by their names alone.
constexpr std::array<std::string_view, 1> handedOut{"plugins/devices/open_stylus/firmware"};

/// What the plugins of one kind share, and build into each of them.
constexpr std::array<std::string_view, 1> sharedByPlugins{"plugins/devices/hid"};

struct ThirdParty {
    std::string_view name;
    bool (*owns)(std::string_view header);
    std::vector<std::string_view> users; ///< libraries, or "ui" for all of ui
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
bool isSqlite(std::string_view header) {
    return header.starts_with("sqlite3");
}

const std::array<ThirdParty, 6> thirdParties{
    ThirdParty{"Qt", isQt, {"ui", "app"}},           ThirdParty{"VTK", isVtk, {"ui/scene"}},
    ThirdParty{"OpenCASCADE", isOcct, {"core/cad"}}, ThirdParty{"SQLite", isSqlite, {"core/document"}},
    ThirdParty{"hidapi", isHidapi, {"plugins"}},     ThirdParty{"libsystemd", isSystemd, {"core/haptics"}}};

std::string firstParts(std::string_view path, std::size_t count) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < count && end != std::string_view::npos; ++i)
        end = path.find('/', end == 0 && i == 0 ? 0 : end + 1);
    return std::string(path.substr(0, end));
}

/// "core/volume", "ui/scene", "app" or "plugins".
std::string libraryOf(std::string_view path) {
    const bool byFolder = path.starts_with("core/") || path.starts_with("ui/");
    return firstParts(path, byFolder ? 2 : 1);
}

/// Everything that `library` may use, itself included.
std::set<std::string> reach(const std::string& library) {
    std::set<std::string> reached{library};
    std::vector<std::string> open{library};
    while (!open.empty()) {
        const std::string next = open.back();
        open.pop_back();
        const auto known = uses.find(next);
        if (known == uses.end()) continue;
        for (const std::string& used : known->second)
            if (reached.insert(used).second) open.push_back(used);
    }
    return reached;
}

bool allowed(const std::string& library, const std::string& header, const std::string& source) {
    if (library == "plugins")
        return std::ranges::find(pluginInterface, header) != pluginInterface.end() ||
               firstParts(header, 3) == firstParts(source, 3) ||
               (firstParts(header, 2) == firstParts(source, 2) &&
                std::ranges::find(sharedByPlugins, firstParts(header, 3)) != sharedByPlugins.end());
    const std::set<std::string> reached = reach(library);
    return reached.contains(libraryOf(header)) || reached.contains(firstParts(header, 1));
}

bool isOurs(std::string_view header) {
    return header.starts_with("core/") || header.starts_with("ui/") || header.starts_with("app/") ||
           header.starts_with("plugins/") || header.starts_with("tests/");
}

/// The header of an #include line with its opening mark, `<vector` or `"core/base/error.h`; empty for another line.
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

std::string thirdPartyFault(const std::string& library, const std::string& header) {
    for (const ThirdParty& party : thirdParties) {
        if (!party.owns(header)) continue;
        const auto uses_ = [&](std::string_view user) { return user == library || user == firstParts(library, 1); };
        if (std::ranges::none_of(party.users, uses_)) return library + " may not include " + std::string(party.name);
    }
    return {};
}

/// What is wrong with one include; empty when nothing is.
std::string faultOf(const std::string& source, const std::string& include) {
    const std::string library = libraryOf(source), header = include.substr(1);
    if (include.starts_with('<')) return thirdPartyFault(library, header);
    if (header.ends_with(".moc")) return {};
    const fs::path folder = fs::path(source).parent_path();
    if (std::ranges::find(handedOut, folder.generic_string()) != handedOut.end())
        return header.find('/') == std::string::npos ? std::string() : "what is handed out stands alone";
    if (!isOurs(header)) return "our headers are named from the root";
    return allowed(library, header, source) ? std::string() : library + " may not use " + libraryOf(header);
}

bool isCode(const fs::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".h" || ending == ".cpp" || ending == ".c" || ending == ".hpp";
}

void checkFile(const fs::path& root, const fs::path& file, std::vector<std::string>& faults) {
    const std::string source = fs::relative(file, root).generic_string();
    if (!uses.contains(libraryOf(source)))
        faults.push_back(source + ": " + libraryOf(source) + " is not in the design");
    std::ifstream stream(file);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::string include = includedBy(line);
        const std::string fault = include.empty() ? std::string() : faultOf(source, include);
        if (!fault.empty()) faults.push_back(source + ":" + std::to_string(number) + ": " + fault);
    }
}

} // namespace

std::vector<std::string> forbiddenIncludes(const fs::path& root) {
    std::vector<std::string> faults;
    for (const char* folder : {"core", "ui", "app", "plugins"}) {
        if (!fs::exists(root / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file() && isCode(entry.path())) checkFile(root, entry.path(), faults);
    }
    std::ranges::sort(faults);
    return faults;
}

} // namespace burin::architecture
