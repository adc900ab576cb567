// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/architecture/arrows.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin::architecture {

/// The header of an #include line with its opening mark, `<vector` or `"core/base/error.h`; empty for another line.
std::string includedBy(std::string_view line);

/// What the sources of a tree include that they may not, one sentence each; empty when all is well.
/// Reads every #include line of core, ui, app and plugins.
std::vector<std::string> forbiddenIncludes(const std::filesystem::path& root, const Arrows& arrows);
/// The libraries of others whose headers `forbiddenIncludes` knows, sorted.
std::vector<std::string> watchedForeignLibraries();

/// Libraries of core that link what their room may not use, one sentence each. Reads every CMakeLists.txt of core.
std::vector<std::string> forbiddenLinks(const std::filesystem::path& root, const Arrows& arrows);

/// Types of one name, in the same namespace, that two files of core, ui or app define; empty when there are none. The
/// linker takes the functions of either for both, and no compiler says a word.
std::vector<std::string> typesDefinedTwice(const std::filesystem::path& root);

/// Source files (C++, CMake, scripts) without the two SPDX lines at their top.
std::vector<std::string> missingLicences(const std::filesystem::path& root, const std::vector<std::string>& files);

/// Files that name a place which exists on one machine alone.
std::vector<std::string> namedMachines(const std::filesystem::path& root, const std::vector<std::string>& files);

/// Files of the project, relative to `root`: what git tracks, or in a tree without git everything but build results.
std::vector<std::string> projectFiles(const std::filesystem::path& root);

} // namespace burin::architecture
