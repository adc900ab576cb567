// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace burin::architecture {

/// References in our pages and comments to files that are not in the tree, one sentence each. In a page: text in
/// backticks that begins with one of our top folders, or is the bare name of a source ("stroke.cpp"). In a source:
/// names of pages ("core/haptics/README.md"; a bare name may be any page of the project).
/// @param files of the project, relative to `root`; pages of tests/fixtures describe files elsewhere and are left out
std::vector<std::string> deadReferences(const std::filesystem::path& root, const std::vector<std::string>& files);

} // namespace burin::architecture
