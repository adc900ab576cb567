// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/architecture/arrows.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin::architecture {

/// The header of an #include line with its opening delimiter, `<vector` or `"core/base/error.h`; empty for any other
/// line.
std::string includedBy(std::string_view line);

/// Forbidden includes in the sources of a tree, one sentence each; empty if there are none. Reads every #include line
/// of core, ui, app and plugins.
std::vector<std::string> forbiddenIncludes(const std::filesystem::path& root, const Arrows& arrows);
/// The third-party libraries whose headers `forbiddenIncludes` knows, sorted.
std::vector<std::string> watchedForeignLibraries();

/// Libraries of core that link what their room may not use, one sentence each. Reads every CMakeLists.txt of core.
std::vector<std::string> forbiddenLinks(const std::filesystem::path& root, const Arrows& arrows);

/// Types with the same name in the same namespace that two files of core, ui or app define; empty if there are none.
/// The linker uses the functions of either for both, and no compiler reports it.
std::vector<std::string> typesDefinedTwice(const std::filesystem::path& root);

/// Source files (C++, CMake, scripts) without the two SPDX lines at their top.
std::vector<std::string> missingLicences(const std::filesystem::path& root, const std::vector<std::string>& files);

/// Files that name a path which exists on one machine only.
std::vector<std::string> namedMachines(const std::filesystem::path& root, const std::vector<std::string>& files);

/// Files of the project, relative to `root`: those tracked by git, or in a tree without git everything except build
/// results.
std::vector<std::string> projectFiles(const std::filesystem::path& root);

} // namespace burin::architecture
