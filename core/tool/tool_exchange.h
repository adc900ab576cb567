// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

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

/// A tool as a file of another program has it, and what that can't hold.
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

/// What a file of a name holds: *.tbl all tools, *.fctb and *.json (Burin's own form) the one of an id.
/// @param unit mm of the machine's unit, of a table
/// Errors: those of both, argumentInvalid (another name; an id that none of them has).
Result<WrittenTools> toolsFor(const std::string& file, const std::string& id, const std::vector<Tool>& tools,
                              double unit);

} // namespace burin
