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
    int feedDecimals = 1; ///< trailing zeros of a feed are omitted
};

/// The arcs that a control accepts. Others are split, or replaced by lines.
struct DialectArcs {
    double largestSweep = 360.0;    ///< degrees; longer arcs are split
    double smallestRadius = 0.01;   ///< mm
    double largestRadius = 1000.0;  ///< mm
    double largestMismatch = 0.002; ///< mm between the written radii at both ends
    bool helices = true;            ///< whether arcs may move along their axis
};

/// A dialect as data: the words of a control, and how a program is composed of them. resources/dialects/<id>.json;
/// those of the user are in dialects/ of the folder that userResourceDirectory returns, and replace ours of the same
/// id. core/nc/README.md explains every key. A word in braces in a block stands for a value: {units} {work_offset}
/// {blend} {blend_end} {tool} {tool_2} (two digits) {speed} {spindle} {coolant} {coolant_off} (empty if no coolant was
/// on) {start_dwell} {program_number} {rapid}, and in `home` {home_x} {home_y} {home_z} (the axis and its position). A
/// block {comments} or {tool_comment} stands for a comment of as many lines as it needs. A block that is empty after
/// that is omitted.
struct DialectData {
    std::string id, name, source, fileSuffix;
    std::string control;                   ///< id of the Control that reads it
    std::array<DialectNumbers, 2> numbers; ///< by NcUnits
    bool forcedPoint = false;              ///< 5 is "5."
    bool leadingZero = true;               ///< "0.5" rather than ".5"
    bool keepZeros = true;                 ///< of coordinates: "5.000"
    int lineLength = 255;
    int lineNumberStep = 0;                ///< 0: lines are not numbered
    std::string commentOpen, commentClose; ///< commentClose empty: to the end of the line
    bool commentUpperCase = false;
    std::optional<std::string> commentCharacters; ///< allowed besides letters, digits and blanks; none: all are
    int programNumberDigits = 4;
    std::array<std::string, 2> units; ///< by NcUnits
    std::string rapid, line, clockwise, anticlockwise;
    std::array<std::string, 3> planes;                 ///< by the axis normal to them
    std::array<std::string, 2> spindle;                ///< by SpindleDirection
    std::array<std::optional<std::string>, 3> coolant; ///< by Coolant; none: the control does not have it
    std::string coolantOff = "M9";                     ///< while the tool cuts
    std::string dwell;                                 ///< with {seconds} or {milliseconds}
    std::optional<std::string> blend, exactStop;       ///< {tolerance}; none: omitted
    std::optional<std::string> blendEnd;               ///< after a tool that was used with `blend`
    std::string workOffset;                            ///< 54 … 59: {offset}
    std::optional<std::string> workOffset59;           ///< G59.1 … G59.3: {offset} is 1 … 3
    std::optional<std::string> furtherWorkOffset;      ///< 1001 …: {offset} is 1 …
    int furtherWorkOffsets = 0;
    bool changesTools = true;       ///< otherwise a program has one tool only
    bool planeBeforeHeight = false; ///< the tool change leaves the tool at the top: X Y first, then Z
    std::string firstHeight;        ///< first block along Z: {rapid}, {clear} (Z with its height), {tool}, {tool_2}
    DialectArcs arcs;
    std::vector<std::string> begin, toolChange, toolEnd, end;   ///< blocks
    std::vector<std::string> speedChange{"S{speed} {spindle}"}; ///< blocks, written while the spindle turns
    /// Blocks that change the coolant while the spindle turns.
    std::vector<std::string> coolantChange{"{coolant_off}", "{coolant}"};
    /// Blocks after the end of each tool that move to MachineProfile::home, for machines that state one; empty: the
    /// control has no words for it.
    std::vector<std::string> home;
};

/// @param origin file name for messages. Errors: resourceInvalid, with the key and its allowed values.
Result<DialectData> dialectFromJson(std::string_view text, const std::string& origin);

} // namespace burin
