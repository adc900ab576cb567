// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

#include <filesystem>

namespace burin {

/// A tool as a file has it, and what the file did not say or Burin can't hold.
struct ReadTool {
    Tool tool;
    std::vector<std::string> notes; ///< English, a sentence each
};

/// Reads a tool: Burin's own JSON, or a tool bit of FreeCAD (.fctb). The kind is found from the content. Of a bit: the
/// form (end mill, ball end, bull nose, drill, V-bit, chamfer), its lengths and angles with their units, flutes; what
/// it lacks is that of `like`, and told. Its id is made of its name.
/// @param origin file name for messages
/// Errors: resourceInvalid (place: the key), notSupported (a form that is none of these).
Result<ReadTool> toolFromText(std::string_view text, const std::string& origin, const Tool& like);

/// All tools of a file that Burin can hold.
struct ReadTools {
    std::vector<ReadTool> tools;      ///< each id once
    std::vector<std::string> leftOut; ///< what is not among them and why; English, a sentence each
};
/// Reads what toolFromText reads, and libraries of other programs: Fusion (.json, or packed: .tools), CAMotics (a tool
/// table .ctbl, or the tools of a project), LinuxCNC (.tbl: numbers, diameters and names; all else is that of `like`).
/// @param unit mm of the machine's unit, of a LinuxCNC table, which states none
/// Errors: those of toolFromText, fileDamaged (an archive), notSupported (none of its tools can be held).
Result<ReadTools> toolsFromText(std::string_view content, const std::string& origin, const Tool& like, double unit);
/// The same of a file; also a FreeCAD library (.fctl), with the bits that it names where they lie beside it, in a
/// folder "Bit" there, or in one beside its own. Errors: also those of readFile.
Result<ReadTools> toolsFromFile(const std::filesystem::path& file, const Tool& like, double unit);

/// Tools as a file of another program has them, and what that can't hold.
struct WrittenTools {
    std::string text;
    std::vector<std::string> notes; ///< English, a sentence each
};
/// A tool bit of FreeCAD. Errors: notSupported (tapered cutters, lollipops, profiles).
Result<WrittenTools> freecadBit(const Tool& tool);
/// A tool table of LinuxCNC, sorted by number, each tool in the pocket of its number; diameters in the machine's unit.
/// Lengths are left at 0: they are measured on the machine. @param unit mm of the machine's unit
/// Errors: argumentInvalid (two tools of one number, a number above 1000, which is no pocket).
Result<WrittenTools> linuxcncTable(std::vector<Tool> tools, double unit);
/// A packed tool library of Fusion, mm. Tools whose flutes are a profile are left out and named.
/// Errors: notSupported (all of them are), outOfMemory.
Result<WrittenTools> fusionLibrary(const std::vector<Tool>& tools);
/// A tool table of CAMotics by number. Forms that it lacks are left out and named.
/// Errors: notSupported (all of them are), argumentInvalid (two tools of one number).
Result<WrittenTools> camoticsTable(const std::vector<Tool>& tools);

/// What a file of a name holds: *.tbl, *.tools and *.ctbl all tools, *.fctb and *.json (Burin's own form) the one of an
/// id. @param unit mm of the machine's unit, of a LinuxCNC table
/// Errors: those of each, argumentInvalid (another name; an id that none of them has).
Result<WrittenTools> toolsFor(const std::string& file, const std::string& id, const std::vector<Tool>& tools,
                              double unit);

} // namespace burin
