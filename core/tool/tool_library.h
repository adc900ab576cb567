// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace burin {

/// The same tool under another id and name; its source says what it was copied from.
Tool copyOf(const Tool& tool, const std::string& id, const std::string& name);

/// The lowest T number that none of them has: two tools of one number can't be in one program.
int freeToolNumber(const std::vector<Tool>& tools);

/// The tool in force under this id is the one that Burin is shipped with: it can be copied, but neither changed nor
/// deleted.
bool isShippedTool(std::string_view id);

/// Checks a tool as a file is checked and adds it to the user's own. @param replace one of the user's of this id
/// @return its file. Errors: resourceInvalid, argumentInvalid (an id that a shipped tool has, or without `replace` one
/// of the user's; no id of a file), fileNotWritable, diskFull.
Result<std::filesystem::path> saveTool(const Tool& tool, bool replace);
/// Deletes one of the user's own. Errors: argumentInvalid (a shipped one), nameUnknown, fileNotWritable.
Result<void> removeTool(const std::string& id);

} // namespace burin
