// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burin::architecture {

/// Which library may use which, read from the tables of core/README.md. A library is "core/volume", "ui/scene", "app"
/// or "plugins"; as a library that is used, "core" stands for all of core and "ui" for all of ui.
class Arrows {
public:
    /// @param page contains the tables whose first columns are called "room" and "library of others"
    static Arrows read(const std::filesystem::path& page);

    bool knows(std::string_view library) const { return uses_.contains(library); }
    /// Whether a library may use another one, directly or through others; true for itself.
    bool allow(const std::string& library, std::string_view used) const;
    /// Whether a library may include a third-party library, such as "Qt".
    bool allowForeign(std::string_view library, std::string_view foreign) const;

    /// The faults of the tables, one sentence each: a library that is listed twice, one that is used but has no row,
    /// dependencies that form a cycle.
    std::vector<std::string> faults() const;
    /// Libraries, sorted.
    std::vector<std::string> libraries() const;
    /// Third-party libraries, sorted.
    std::vector<std::string> foreignLibraries() const;

private:
    std::set<std::string> reach(const std::string& library) const;

    using Lists = std::map<std::string, std::vector<std::string>, std::less<>>;
    Lists uses_;         ///< by library
    Lists foreignUsers_; ///< by third-party library
    std::vector<std::string> twice_;
};

/// The first `count` parts of a path with slashes.
std::string firstParts(std::string_view path, std::size_t count);
/// The library that a file of the repository belongs to: "core/volume", "ui/scene", "app", "plugins", "tests".
std::string libraryOf(std::string_view file);

} // namespace burin::architecture
