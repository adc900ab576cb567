// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace burin::architecture {

/// What our pages and comments name that is not in the tree, one sentence each. In a page: what stands between
/// backticks and begins with one of our top folders, or is the bare name of a source ("stroke.cpp"). In a source: pages
/// ("core/haptics/README.md"; of a bare name any page of the project).
/// @param files of the project, relative to `root`; pages of tests/fixtures tell of files elsewhere and are left out
std::vector<std::string> deadReferences(const std::filesystem::path& root, const std::vector<std::string>& files);

} // namespace burin::architecture
