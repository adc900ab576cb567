// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/arrows.h"

#include "tests/architecture/page_table.h"

#include <algorithm>

namespace burin::architecture {

namespace {

/// Backticks are optional in a table's first column.
std::string nameIn(const std::string& cell) {
    const std::vector<std::string> quoted = quotedIn(cell);
    return quoted.empty() ? cell : quoted.front();
}

} // namespace

Arrows Arrows::read(const std::filesystem::path& page) {
    Arrows arrows;
    const auto fill = [&](std::string_view heading, Lists& lists) {
        for (const PageRow& row : tableOf(page, heading)) {
            const std::string name = row.empty() ? std::string() : nameIn(row.front());
            const std::vector<std::string> used = row.size() > 1 ? quotedIn(row[1]) : std::vector<std::string>();
            if (!lists.emplace(name, used).second) arrows.twice_.push_back(name);
        }
    };
    fill("room", arrows.uses_);
    fill("library of others", arrows.foreignUsers_);
    return arrows;
}

/// Everything that `library` may use, itself included.
std::set<std::string> Arrows::reach(const std::string& library) const {
    std::set<std::string> reached{library};
    std::vector<std::string> open{library};
    while (!open.empty()) {
        const auto known = uses_.find(open.back());
        open.pop_back();
        if (known == uses_.end()) continue;
        for (const std::string& used : known->second)
            if (reached.insert(used).second) open.push_back(used);
    }
    return reached;
}

bool Arrows::allow(const std::string& library, std::string_view used) const {
    const std::set<std::string> reached = reach(library);
    return reached.contains(std::string(used)) || reached.contains(firstParts(used, 1));
}

bool Arrows::allowForeign(std::string_view library, std::string_view foreign) const {
    const auto users = foreignUsers_.find(foreign);
    return users != foreignUsers_.end() && std::ranges::any_of(users->second, [&](const std::string& user) {
               return user == library || user == firstParts(library, 1);
           });
}

std::vector<std::string> Arrows::faults() const {
    std::vector<std::string> faults;
    for (const std::string& name : twice_) faults.push_back(name + " stands in two rows");
    for (const auto& [library, uses] : uses_)
        for (const std::string& used : uses) {
            if (used != "core" && used != "ui" && !uses_.contains(used))
                faults.push_back(library + " may use " + used + ", which has no row");
            if (reach(used).contains(library)) faults.push_back(library + " and " + used + " make a circle");
        }
    return faults;
}

std::vector<std::string> Arrows::libraries() const {
    std::vector<std::string> names;
    for (const auto& [library, uses] : uses_) names.push_back(library);
    return names;
}

std::vector<std::string> Arrows::foreignLibraries() const {
    std::vector<std::string> names;
    for (const auto& [foreign, users] : foreignUsers_) names.push_back(foreign);
    return names;
}

std::string firstParts(std::string_view path, std::size_t count) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < count && end != std::string_view::npos; ++i)
        end = path.find('/', end == 0 && i == 0 ? 0 : end + 1);
    return std::string(path.substr(0, end));
}

std::string libraryOf(std::string_view file) {
    const bool byFolder = file.starts_with("core/") || file.starts_with("ui/");
    return firstParts(file, byFolder ? 2 : 1);
}

} // namespace burin::architecture
