// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool_exchange.h"

#include <nlohmann/json.hpp>

namespace burin {

// What readers of other programs' tool libraries share.

/// Checks a tool that was put together as a file of Burin's own is checked, with its id made of its name.
/// @param like lends the limits. Errors: resourceInvalid.
Result<ReadTool> soundTool(ReadTool read, const std::string& origin, const Tool& like);

/// A whole number, within what an int holds.
int wholeNumberOf(const nlohmann::json& value);

/// Of a Fusion library. Errors: those of soundTool for all of its tools.
Result<ReadTools> readFusion(const nlohmann::json& library, const std::string& origin, const Tool& like);
/// Of an object of CAMotics' tools by number.
Result<ReadTools> readCamotics(const nlohmann::json& tools, const std::string& origin, const Tool& like);
/// Whether it is such an object.
bool isCamoticsTable(const nlohmann::json& json);
/// Of a LinuxCNC tool table. @param unit mm
Result<ReadTools> readLinuxcnc(std::string_view text, const std::string& origin, const Tool& like, double unit);
/// Whether it may be one: a line begins with T and a number.
bool isLinuxcncTable(std::string_view text);

} // namespace burin
