// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <map>
#include <optional>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

/// Removes `start` from the front of a line that begins with it.
bool skip(std::string_view& line, std::string_view start) {
    if (!line.starts_with(start)) return false;
    line.remove_prefix(start.size());
    return true;
}

/// Removes the text from `open`, which begins the line, to the matching `close`.
std::string_view takeBrackets(std::string_view& line, char open, char close) {
    int depth = 0;
    std::size_t end = 0;
    do {
        if (line[end] == open) ++depth;
        if (line[end] == close) --depth;
        ++end;
    } while (depth > 0 && end < line.size());
    const std::string_view taken = line.substr(0, end);
    line.remove_prefix(end);
    return taken;
}

/// Removes a name with its scopes and its template specialisation arguments.
std::string takeName(std::string_view& line) {
    std::string name;
    while (!line.empty())
        if (std::isalnum(static_cast<unsigned char>(line[0])) != 0 || line[0] == '_') {
            name += line[0];
            line.remove_prefix(1);
        } else if (skip(line, "::")) {
            name += "::";
        } else if (line[0] == '<') {
            name += takeBrackets(line, '<', '>');
        } else {
            break;
        }
    return name;
}

/// Removes `[[nodiscard]] alignas(64) ` and the like.
void skipAttributes(std::string_view& line) {
    for (;; skip(line, " "))
        if (line.starts_with("[["))
            takeBrackets(line, '[', ']');
        else if (skip(line, "alignas"))
            takeBrackets(line, '(', ')');
        else
            return;
}

/// The type whose definition begins on a line, as our formatter writes it: at the beginning of the line.
std::optional<std::string> definedBy(std::string_view line) {
    if (skip(line, "template ")) {
        takeBrackets(line, '<', '>');
        if (!skip(line, " ")) return std::nullopt;
    }
    constexpr std::array<std::string_view, 5> kinds{"struct ", "class ", "union ", "enum class ", "enum "};
    if (std::ranges::none_of(kinds, [&](std::string_view kind) { return skip(line, kind); })) return std::nullopt;
    skipAttributes(line);
    std::string name = takeName(line);
    const bool head = line.empty() || line.starts_with(" {") || line.starts_with(" :") || line.starts_with(" final");
    const bool declaredOnly = line.ends_with(';') && line.find('{') == std::string_view::npos;
    return !name.empty() && head && !declaredOnly ? std::optional(std::move(name)) : std::nullopt;
}

/// The namespaces that are open, as our formatter begins and ends them.
class OpenNamespaces {
public:
    /// Whether the line opens or closes a namespace.
    bool read(std::string_view line) {
        if (line.starts_with("} // namespace") && !names_.empty()) {
            names_.pop_back();
            return true;
        }
        skip(line, "inline ");
        if (!skip(line, "namespace ") || !line.ends_with('{')) return false;
        names_.push_back(takeName(line));
        return true;
    }
    /// Whether types of another file can collide with those here: not in an unnamed namespace, nor in a fragment that
    /// others include within their own namespace.
    bool seenByOthers() const { return !names_.empty() && std::ranges::find(names_, std::string()) == names_.end(); }
    std::string nameOf(const std::string& type) const {
        std::string whole;
        for (const std::string& name : names_) whole += name + "::";
        return whole + type;
    }

private:
    std::vector<std::string> names_;
};

std::vector<std::string> typesOf(const fs::path& file) {
    std::vector<std::string> types;
    OpenNamespaces open;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (open.read(line) || !open.seenByOthers()) continue;
        if (const std::optional<std::string> type = definedBy(line)) types.push_back(open.nameOf(*type));
    }
    std::ranges::sort(types);
    const auto rest = std::ranges::unique(types); // several such types of which the processor's instructions select one
    types.erase(rest.begin(), rest.end());
    return types;
}

std::vector<fs::path> sourcesOf(const fs::path& root) {
    std::vector<fs::path> files;
    for (const char* folder : {"core", "ui", "app"}) {
        if (!fs::exists(root / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

std::vector<std::string> typesDefinedTwice(const fs::path& root) {
    std::map<std::string, std::string> places;
    std::vector<std::string> faults;
    for (const fs::path& file : sourcesOf(root)) {
        const std::string source = fs::relative(file, root).generic_string();
        for (const std::string& type : typesOf(file))
            if (const auto [first, isNew] = places.emplace(type, source); !isNew)
                faults.push_back(source + ": " + type + " is another type in " + first->second);
    }
    return faults;
}

} // namespace burin::architecture
