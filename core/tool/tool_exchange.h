// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

#include <filesystem>

namespace burin {

/// A tool read from a file, with notes about what the file did not state or Burin can't represent.
struct ReadTool {
    Tool tool;
    std::vector<std::string> notes; ///< English, one sentence each
};

/// Reads a tool: Burin's own JSON, or a tool bit of FreeCAD (.fctb). The kind is detected from the content. From a bit,
/// the shape (end mill, ball end, bull nose, drill, V-bit, chamfer), its lengths and angles with their units, and the
/// flutes are read; missing values are taken from `like`, with a note. The id is made from the name.
/// @param origin file name for messages
/// Errors: resourceInvalid (place: the key), notSupported (any other shape).
Result<ReadTool> toolFromText(std::string_view text, const std::string& origin, const Tool& like);

/// All tools of a file that Burin can represent.
struct ReadTools {
    std::vector<ReadTool> tools;      ///< with unique ids
    std::vector<std::string> leftOut; ///< tools that were left out and why; English, one sentence each
};
/// Reads the formats of toolFromText, and libraries of other programs: Fusion (.json, or packed: .tools), CAMotics (a
/// tool table .ctbl, or the tools of a project), LinuxCNC (.tbl: numbers, diameters and names; everything else is taken
/// from `like`).
/// @param unit machine unit in mm, for a LinuxCNC table, which states none
/// Errors: those of toolFromText, fileDamaged (an archive), notSupported (none of its tools can be represented).
Result<ReadTools> toolsFromText(std::string_view content, const std::string& origin, const Tool& like, double unit);
/// The same for a file; also reads a FreeCAD library (.fctl) with the bits that it names, which lie next to it, in a
/// folder "Bit" there, or in a folder "Bit" next to its own folder. Errors: also those of readFile.
Result<ReadTools> toolsFromFile(const std::filesystem::path& file, const Tool& like, double unit);

/// Tools in the file format of another program, with notes about what that format can't represent.
struct WrittenTools {
    struct File {
        std::filesystem::path file;
        std::string text;
    };
    std::string text;
    std::vector<std::string> notes; ///< English, a sentence each
    std::vector<File> files{};      ///< further files that belong to it: the bits of a FreeCAD library
};
/// Returns a tool bit of FreeCAD. Errors: notSupported (tapered cutters, lollipops, profiles).
Result<WrittenTools> freecadBit(const Tool& tool);
/// Returns a library of FreeCAD (.fctl) with its bits, which lie in a folder "Bit": next to the library's folder if
/// that is called "Library", as FreeCAD has it, otherwise in the library's folder. A bit that is there already and that
/// the replaced library does not name is kept; the new one gets a number appended to its name. Tools whose shapes no
/// bit has are left out and named in the notes. Errors: notSupported (all of them are), argumentInvalid (two tools with
/// the same number). @param file of the library; its stem becomes the label
Result<WrittenTools> freecadLibrary(const std::filesystem::path& file, const std::vector<Tool>& tools);
/// Returns a tool table of LinuxCNC, sorted by number, each tool in the pocket of its number; diameters in the
/// machine's unit. Lengths are left at 0: they are measured on the machine. @param unit machine unit in mm
/// Errors: argumentInvalid (two tools with the same number, a number above 1000, which is not a pocket).
Result<WrittenTools> linuxcncTable(std::vector<Tool> tools, double unit);
/// Returns a packed tool library of Fusion, mm. Tools whose flutes are a profile are left out and named in the notes.
/// Errors: notSupported (all of them are), outOfMemory.
Result<WrittenTools> fusionLibrary(const std::vector<Tool>& tools);
/// Returns a tool table of CAMotics by number. Tools with shapes that it lacks are left out and named in the notes.
/// Errors: notSupported (all of them are), argumentInvalid (two tools with the same number).
Result<WrittenTools> camoticsTable(const std::vector<Tool>& tools);

/// Returns the content for a file by its name: *.fctl, *.tbl, *.tools and *.ctbl contain all tools, *.fctb and *.json
/// (Burin's own form) the one with the given id. Errors: those of each format, argumentInvalid (another name; an id
/// that none of them has). @param unit machine unit in mm, for a LinuxCNC table
Result<WrittenTools> toolsFor(const std::string& file, const std::string& id, const std::vector<Tool>& tools,
                              double unit);
/// Writes tools to a file, together with the further files that belong to it: all of them or none. Creates their
/// folders. Errors: those of StagedFile.
Result<void> writeTools(const std::filesystem::path& file, const WrittenTools& written);

} // namespace burin
