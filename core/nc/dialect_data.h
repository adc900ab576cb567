// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// How numbers of one unit are written.
struct DialectNumbers {
    int decimals = 3;     ///< of coordinates
    int feedDecimals = 1; ///< the zeros at a feed's end are left out
};

/// What a control takes for an arc. What it does not take is split, or made of lines.
struct DialectArcs {
    double largestSweep = 360.0;    ///< degrees; longer ones are split
    double smallestRadius = 0.01;   ///< mm
    double largestRadius = 1000.0;  ///< mm
    double largestMismatch = 0.002; ///< mm between the radii of both ends, as written
    bool helices = true;            ///< with a move along the axis
};

/// A dialect as data: the words of a control, and how a program is put together from them.
/// resources/dialects/<id>.json; the user's own stand in dialects/ of the folder that userResourceDirectory names, and
/// replace ours of the same id. core/nc/README.md explains every key. In the blocks a word in braces stands for a
/// value: {units} {work_offset} {blend} {blend_end} {tool} {tool_2} (two digits) {speed} {spindle} {coolant}
/// {start_dwell} {program_number} {rapid}, and in `home` {home_x} {home_y} {home_z} (the axis and its position); a
/// block that is one of {comments}, {tool_comment} stands for a comment of as many lines as it needs. A block of which
/// nothing is left is left out.
struct DialectData {
    std::string id, name, source, fileSuffix;
    std::string control;                   ///< id of the Control that reads it
    std::array<DialectNumbers, 2> numbers; ///< by NcUnits
    bool forcedPoint = false;              ///< 5 is "5."
    bool leadingZero = true;               ///< "0.5" rather than ".5"
    bool keepZeros = true;                 ///< of coordinates: "5.000"
    int lineLength = 255;
    int lineNumberStep = 0;                ///< 0: lines are not numbered
    std::string commentOpen, commentClose; ///< the latter empty: to the line's end
    bool commentUpperCase = false;
    std::optional<std::string> commentCharacters; ///< that may stand besides letters, digits and blanks; else any
    int programNumberDigits = 4;
    std::array<std::string, 2> units; ///< by NcUnits
    std::string rapid, line, clockwise, anticlockwise;
    std::array<std::string, 3> planes;                 ///< by the axis across them
    std::array<std::string, 2> spindle;                ///< by SpindleDirection
    std::array<std::optional<std::string>, 3> coolant; ///< by Coolant; nothing: the control has none
    std::string dwell;                                 ///< with {seconds} or {milliseconds}
    std::optional<std::string> blend, exactStop;       ///< {tolerance}; nothing: left out
    std::optional<std::string> blendEnd;               ///< behind a tool that was used with `blend`
    std::string workOffset;                            ///< 54 … 59: {offset}
    std::optional<std::string> workOffset59;           ///< G59.1 … G59.3: {offset} is 1 … 3
    std::optional<std::string> furtherWorkOffset;      ///< 1001 …: {offset} is 1 …
    int furtherWorkOffsets = 0;
    bool changesTools = true;       ///< else a program is of one tool
    bool planeBeforeHeight = false; ///< the tool change leaves the tool at the top: first X Y, then Z
    std::string firstHeight;        ///< first block along Z: {rapid}, {clear} (Z and its height), {tool}, {tool_2}
    DialectArcs arcs;
    std::vector<std::string> begin, toolChange, toolEnd, end;   ///< blocks
    std::vector<std::string> speedChange{"S{speed} {spindle}"}; ///< blocks; the spindle turns already
    /// Blocks behind each tool's end that go to MachineProfile::home, for machines that state one; empty: the control
    /// has no words for it.
    std::vector<std::string> home;
};

/// @param origin file name for messages. Errors: resourceInvalid, with the key and what it has to be.
Result<DialectData> dialectFromJson(std::string_view text, const std::string& origin);

} // namespace burin
