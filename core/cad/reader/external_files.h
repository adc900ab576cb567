// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <STEPControl_Reader.hxx>

#include <filesystem>
#include <set>
#include <string>

namespace burin {

/// The external files that a STEP file refers to for its parts, by their names in it, as valid UTF-8.
struct ExternalFiles {
    std::set<std::string> missing; ///< not in the folder of the file
    std::set<std::string> outside; ///< names that contain a folder: nothing outside the file's own folder is read
    bool circular = false;         ///< a file refers to itself, directly or through others
};

/// Checks a file that was read but not yet transferred, and all files that it refers to, recursively. OpenCASCADE's
/// transfer reads whatever files are named, wherever they are, and follows a circular reference endlessly.
ExternalFiles externalFilesOf(const STEPControl_Reader& reader, const std::filesystem::path& file);

/// Returns the names separated by commas: "a.stp, b.stp"
std::string joined(const std::set<std::string>& names);

} // namespace burin
