// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <STEPControl_Reader.hxx>

#include <filesystem>
#include <set>
#include <string>

namespace burin {

/// The other files that a STEP file leaves its parts to, by their names in it, as valid UTF-8.
struct ExternalFiles {
    std::set<std::string> missing; ///< not beside the file
    std::set<std::string> outside; ///< with a folder in their names: nothing out of the file's own folder is read
    bool circular = false;         ///< a file refers to itself, perhaps through others
};

/// Looks through a file that was read but not yet transferred, and through what it refers to in turn.
/// OpenCASCADE's transfer reads whatever a file names, wherever it is, and follows a circle without end.
ExternalFiles externalFilesOf(const STEPControl_Reader& reader, const std::filesystem::path& file);

/// "a.stp, b.stp"
std::string joined(const std::set<std::string>& names);

} // namespace burin
