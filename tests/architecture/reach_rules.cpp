// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/reach_rules.h"

#include "tests/architecture/arrows.h"
#include "tests/architecture/include_rules.h"
#include "tests/architecture/page_table.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <set>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string, std::less<>>;

/// The parts of a file that the rules examine.
struct Source {
    std::vector<std::string> includes; ///< ours, relative to the root
    Names words;                       ///< identifiers outside of comments
    Names defined;                     ///< functions, and classes with member functions, at the beginnings of lines
    bool hasHeader = false;            ///< a header of the same name in the same folder
};
using Sources = std::map<std::string, Source>; // by file

bool isWordPart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view withoutComment(std::string_view line) {
    return line.substr(0, line.find("//"));
}

void addWords(std::string_view line, Names& words) {
    for (std::size_t i = 0; i < line.size();) {
        std::size_t end = i;
        while (end < line.size() && isWordPart(line[end])) ++end;
        if (end > i) words.emplace(line.substr(i, end - i));
        i = end + 1;
    }
}

/// The name in front of an opening bracket, with its scopes: "Project::TakeWriter::append".
std::string scopedNameBefore(std::string_view line, std::size_t bracket) {
    std::size_t begin = bracket;
    while (begin > 0 && (isWordPart(line[begin - 1]) || line[begin - 1] == ':' || line[begin - 1] == '~')) --begin;
    return std::string(line.substr(begin, bracket - begin));
}

/// The name defined or declared by a line that begins a function at the left edge, as our formatter writes it: the
/// function's name, or that of its class for a member.
std::optional<std::string> functionOf(std::string_view line) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) return std::nullopt;
    for (const std::string_view other :
         {"namespace", "using", "static_assert", "struct ", "class ", "enum ", "template"})
        if (line.starts_with(other)) return std::nullopt;
    const std::size_t bracket = line.find('(');
    if (bracket == std::string_view::npos) return std::nullopt;
    std::string name = scopedNameBefore(line, bracket);
    if (const std::size_t scope = name.find("::"); scope != std::string::npos) name.resize(scope);
    return name.empty() ? std::nullopt : std::optional(std::move(name));
}

Source sourceIn(const fs::path& file, const fs::path& root) {
    Source source;
    std::ifstream stream(file);
    bool hidden = false; // in an unnamed namespace
    for (std::string line; std::getline(stream, line);) {
        if (const std::string included = includedBy(line); included.starts_with('"')) {
            if (fs::exists(root / included.substr(1))) source.includes.push_back(included.substr(1));
            continue;
        }
        addWords(withoutComment(line), source.words);
        if (line == "namespace {") hidden = true;
        if (line == "} // namespace") hidden = false;
        if (hidden) continue;
        if (std::optional<std::string> function = functionOf(line)) source.defined.insert(std::move(*function));
    }
    source.hasHeader = file.extension() == ".cpp" && fs::exists(fs::path(file).replace_extension(".h"));
    return source;
}

Sources sourcesOf(const fs::path& root) {
    Sources sources;
    for (const std::string& file : projectFiles(root)) {
        const std::string top = firstParts(file, 1), ending = fs::path(file).extension().string();
        const bool ours = top == "core" || top == "ui" || top == "app" || top == "plugins";
        if (ours && (ending == ".h" || ending == ".cpp" || ending == ".c"))
            sources.emplace(file, sourceIn(root / file, root));
    }
    return sources;
}

/// Headers of a file's room that it includes, directly or through others.
std::set<std::string> roomHeaders(const Sources& sources, const std::string& file) {
    std::set<std::string> seen;
    std::vector<std::string> open{file};
    while (!open.empty()) {
        const auto source = sources.find(open.back());
        open.pop_back();
        if (source == sources.end()) continue;
        for (const std::string& header : source->second.includes)
            if (seen.insert(header).second) open.push_back(header);
    }
    std::erase_if(seen, [&](const std::string& header) { return libraryOf(header) != libraryOf(file); });
    return seen;
}

class Reach {
public:
    explicit Reach(const Sources& sources) : sources_(sources) {
        for (const auto& [file, source] : sources)
            if (!file.starts_with("core/")) add(file);
        for (const auto& [file, source] : sources)
            if (file.starts_with("core/") && file.ends_with(".cpp"))
                headers_[file] = source.hasHeader ? std::set{fs::path(file).replace_extension(".h").generic_string()}
                                                  : roomHeaders(sources, file);
        while (grow()) {
        }
    }
    bool contains(const std::string& file) const { return reached_.contains(file); }

private:
    /// Adds a file and everything that it includes.
    void add(const std::string& file) {
        const auto source = sources_.find(file);
        if (source == sources_.end() || !reached_.insert(file).second) return;
        for (const std::string& header : source->second.includes) add(header);
    }
    bool grow() {
        bool grew = false;
        for (const auto& [file, headers] : headers_) {
            if (contains(file) || !isImplemented(file, headers)) continue;
            add(file);
            grew = true;
        }
        return grew;
    }
    /// Whether a reached file needs the source.
    bool isImplemented(const std::string& file, const std::set<std::string>& headers) const {
        const Source& source = sources_.at(file);
        if (source.hasHeader) return contains(*headers.begin());
        for (const std::string& name : source.defined) {
            Names declaring;
            for (const std::string& header : headers)
                if (contains(header) && sources_.at(header).words.contains(name)) declaring.insert(header);
            if (!declaring.empty() && isMentioned(name, declaring)) return true;
        }
        return false;
    }
    bool isMentioned(const std::string& name, const Names& declaring) const {
        return std::ranges::any_of(reached_, [&](const std::string& file) {
            return !declaring.contains(file) && sources_.at(file).words.contains(name);
        });
    }

    const Sources& sources_;
    std::map<std::string, std::set<std::string>> headers_; ///< by source: the headers that it may implement
    std::set<std::string> reached_;
};

} // namespace

std::vector<std::string> unreachedSources(const fs::path& root) {
    const Sources sources = sourcesOf(root);
    const Reach reach(sources);
    std::vector<std::string> unreached;
    for (const auto& [file, source] : sources)
        if (!reach.contains(file)) unreached.push_back(file);
    return unreached;
}

std::map<std::string, std::string> reasonsToStay(const fs::path& page) {
    std::map<std::string, std::string> reasons;
    for (const PageRow& row : tableOf(page, "source"))
        if (row.size() > 1)
            for (const std::string& source : quotedIn(row[0])) reasons[source] = row[1];
    return reasons;
}

std::vector<std::string> faultsOfReasons(const std::vector<std::string>& unreached,
                                         const std::map<std::string, std::string>& reasons) {
    std::vector<std::string> faults;
    std::set<std::string> needed;
    for (const std::string& file : unreached) {
        const std::string source = fs::path(file).replace_extension().generic_string();
        if (!reasons.contains(source))
            faults.push_back(file + " is reached by no program, and no reason says why it stays");
        needed.insert(source);
    }
    for (const auto& [source, reason] : reasons) {
        if (!needed.contains(source))
            faults.push_back(source + " needs no reason: a program reaches it, or it is gone");
        if (reason.empty()) faults.push_back(source + " has an empty reason");
    }
    return faults;
}

} // namespace burin::architecture
