// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

// Tools form libraries. Those that Burin is shipped with are the starter library, the user's own are in libraries that
// the user has named, and in the library of own tools where they are in none of these. The files of all own tools stay
// in one folder, so that an id names one tool; which library a tool is in is stated by one file,
// $XDG_DATA_HOME/burin/tool-libraries.json, which need not exist.

inline constexpr std::string_view allTools = "all", starterLibrary = "starter", ownLibrary = "mine";

/// The libraries named by the user.
struct ToolLibraries {
    std::vector<std::string> names;            ///< sorted
    std::map<std::string, std::string> ofTool; ///< library by the id of a tool, which need not exist any more

    bool contains(std::string_view name) const;
    /// Returns the library that a tool is in: starterLibrary, ownLibrary or a name.
    std::string libraryOf(const std::string& tool) const;
    /// @param library one of these, or allTools, which every tool is in
    bool isIn(const std::string& tool, std::string_view library) const;
};

/// Returns no libraries if there is no such file yet. Errors: resourceInvalid, those of readFile.
Result<ToolLibraries> loadToolLibraries();

/// Errors: argumentInvalid (a name that is empty, longer than a line or reserved).
Result<void> checkLibraryName(const std::string& name);
/// Checks that own tools can be in this library. Errors: argumentInvalid (starterLibrary, allTools), nameUnknown.
Result<void> checkOwnLibrary(const ToolLibraries& libraries, const std::string& name);
/// Returns a permitted name of a new library: the given one, shortened if it is too long, with a number appended if a
/// library has it already or it is reserved.
std::string freeLibraryName(const ToolLibraries& libraries, const std::string& name);

// Changes of the file. Errors: those of loadToolLibraries, checkLibraryName, writeFileAtomically.

/// Errors: also argumentInvalid (a library with this name exists).
Result<void> addToolLibrary(const std::string& name);
/// Errors: also nameUnknown, argumentInvalid (a library with the new name exists).
Result<void> renameToolLibrary(const std::string& from, const std::string& to);
/// Its tools are then in ownLibrary. Errors: also nameUnknown.
Result<void> removeToolLibrary(const std::string& name);
/// Puts one of the user's own tools into a library. Errors: also those of checkOwnLibrary.
Result<void> putTool(const std::string& tool, const std::string& library);

} // namespace burin
