// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace burin {

/// Returns the same tool with another id and name; its source states what it was copied from.
Tool copyOf(const Tool& tool, const std::string& id, const std::string& name);

/// Returns the lowest unused T number: two tools with the same number can't be in one program.
int freeToolNumber(const std::vector<Tool>& tools);

/// Whether the tool with this id is one shipped with Burin: it can be copied, but neither changed nor deleted.
bool isShippedTool(std::string_view id);

/// Checks a tool like one read from a file and adds it to the user's tools. @param replace overwrite a user's tool with
/// this id
/// @return its file. Errors: resourceInvalid, argumentInvalid (the id of a shipped tool or, without `replace`, of a
/// user's tool; an id that is not a valid file name), fileNotWritable, diskFull.
Result<std::filesystem::path> saveTool(const Tool& tool, bool replace);
/// Deletes one of the user's tools. Errors: argumentInvalid (a shipped one), nameUnknown, fileNotWritable.
Result<void> removeTool(const std::string& id);

} // namespace burin
