// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "app/library_command.h"
#include "core/tool/tool.h"
#include "core/tool/tool_libraries.h"

#include <memory>
#include <string>
#include <vector>

namespace burin {

inline constexpr const char* usualTool = "flat-6"; ///< supplies values that a file of another program lacks

/// Returns what the answers of several commands state of a tool. @param library that it is in
nlohmann::json briefOf(const Tool& tool, const std::string& library);
/// Returns notes as indented lines, each after a line end.
std::string linesOf(const std::vector<std::string>& notes);

/// Returns the user's libraries. @param chosen argument of --library; empty: all
/// Errors: those of loadToolLibraries; nameUnknown (no such library).
Result<ToolLibraries> librariesWith(const std::string& chosen);
/// Returns the ids of the tools in a library, sorted. @param library empty: all
std::vector<std::string> listedIds(const ToolLibraries& libraries, const std::string& library);
/// Loads a tool. Errors: those of librariesWith and loadTool; nameUnknown (it is not in the library).
Result<Tool> listedTool(const std::string& id, const std::string& library);
/// Stores one of the user's own tools, and answers. @param library empty: where it is; a new tool: ownLibrary
/// @param more of the answer @param notes lines after the answer's text @return exit status
int keepTool(const Tool& tool, bool replace, const std::string& library, CommandContext& context,
             nlohmann::json more = nlohmann::json::object(), const std::string& notes = {});

// Declare further subcommands of `tools`. @param chosen has the argument of --library when they run
void registerToolExchange(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                          int& status);
void registerToolLibraries(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                           int& status);
void registerToolPreset(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                        int& status);

} // namespace burin
