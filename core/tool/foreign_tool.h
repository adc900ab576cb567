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

/// Returns the text that an object has for a key; empty if it has none, or something else.
std::string textIn(const nlohmann::json& of, const char* key);
/// Returns the number that an object has for a key; 0 if it has none, or something else.
double numberIn(const nlohmann::json& of, const char* key);

// Presets of other programs.
/// Adds a preset to a tool as it was read: its name is made unique, and its material becomes an id. What Burin can't
/// represent is left out with a note. @param material as the other program calls it; empty: any
void addForeignPreset(CuttingPreset preset, std::string_view material, ReadTool& read);
/// Leaves out presets, or steps of them, that are beyond the tool's own limits, with a note each.
void keepSoundPresets(ReadTool& read);
/// Returns the surface speed of a spindle speed in 1/min, m/min, and the reverse.
double surfaceSpeedOf(double spindleSpeed, double diameter) noexcept;
double spindleSpeedOf(double surfaceSpeed, double diameter) noexcept;
/// Reads the presets of a tool of a Fusion library, whose shape has been read. @param unit mm, of the tool's lengths
void readFusionPresets(const nlohmann::json& item, double unit, ReadTool& read);
nlohmann::json fusionPresets(const Tool& tool);
/// Reads the presets of a FreeCAD bit whose shape has been read.
void readFreecadPresets(const nlohmann::json& bit, ReadTool& read);
nlohmann::ordered_json freecadPresets(const Tool& tool);

/// Adds a note if one of the tools has presets, for formats that have none.
void noteLostPresets(const std::vector<Tool>& tools, WrittenTools& written);

/// Returns an integer, limited to the range of int.
int wholeNumberOf(const nlohmann::json& value);

/// A note of each FreeCAD bit that is written.
inline constexpr const char* lostInBit = "Holder, number and limits have no place in a bit and were left out.";
/// Whether the JSON value is a FreeCAD library: a list of paths to bits.
bool isFreecadLibrary(const nlohmann::json& file);
/// Reads a FreeCAD library with the bits that it names. @param file of the library
Result<ReadTools> readFreecadLibrary(const nlohmann::json& library, const std::filesystem::path& file,
                                     const Tool& like);
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
