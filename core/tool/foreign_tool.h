// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool_exchange.h"

#include <nlohmann/json.hpp>

namespace burin {

// Shared by the readers of other programs' tool libraries.

/// Checks an assembled tool like one of Burin's own files; its id is made from its name.
/// @param like provides the limits. Errors: resourceInvalid.
Result<ReadTool> soundTool(ReadTool read, const std::string& origin, const Tool& like);

/// Returns an integer, limited to the range of int.
int wholeNumberOf(const nlohmann::json& value);

/// Reads a Fusion library. Errors: those of soundTool for all of its tools.
Result<ReadTools> readFusion(const nlohmann::json& library, const std::string& origin, const Tool& like);
/// Reads a JSON object with CAMotics' tools by number.
Result<ReadTools> readCamotics(const nlohmann::json& tools, const std::string& origin, const Tool& like);
/// Whether the JSON value is such an object.
bool isCamoticsTable(const nlohmann::json& json);
/// Reads a LinuxCNC tool table. @param unit mm
Result<ReadTools> readLinuxcnc(std::string_view text, const std::string& origin, const Tool& like, double unit);
/// Whether the text may be a LinuxCNC tool table: a line begins with T and a number.
bool isLinuxcncTable(std::string_view text);

} // namespace burin
