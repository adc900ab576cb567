// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace burin {

/// What can be wrong with a program's text, for the parser and for lint.
enum class ProgramProblem : std::uint8_t {
    // the line as such
    lineTooLong,
    characterNotAllowed,
    commentNotClosed,
    commentNested,
    percentNotAlone,
    percentNotRead,
    percentMisplaced,
    lineNumberNotFirst,
    // words
    wordNotRead,
    wordTwice,
    wordWithoutUse,
    numberMissing,
    numberOutOfRange,
    numberNotWhole,
    numberNegative,
    pointMissing,
    codeNotRead,
    codesOfOneGroup,
    tooManyMWords,
    codeReadsAxes,
    // parameters and expressions
    expressionNotRead,
    expressionInvalid,
    expressionUndefined,
    parameterNotAllowed,
    parameterUnknown,
    // state
    tooManyMoves,
    cutterCompensation,
    subprogram,
    toolNotSelected,
    workOffsetMissing,
    lengthOffsetMissing,
    unitsChangeBesideFeed,
    feedMissing,
    feedMissingInverseTime,
    spindleStandsStill,
    dwellMissing,
    dwellMoves,
    placeUnknown,
    axisMissing,
    axisWithoutMotion,
    machineFrameMotion,
    // arcs
    arcCentreMissing,
    arcOffsetAcross,
    arcOffsetWithoutArc,
    arcRadiusZero,
    arcRadiusDiffers,
    arcRadiusTooSmall,
    arcRadiusFullTurn,
    arcRadiusAndCentre,
    arcTurns,
    // canned cycles
    cycleFeedMode,
    cycleHeightMissing,
    cycleDepthMissing,
    cycleHeightBelowDepth,
    cycleWordMissing,
    cycleStep,
    cycleSpindle,
    cycleRepeats,
    // lint alone
    endMissing,
    feedAboveMachine,
    spindleBeyondMachine,
    arcModeMissing,
    unitsMissing,
    feedPointMissing,
    count
};

/// Stable id: "line_too_long".
std::string_view idOf(ProgramProblem problem) noexcept;
/// What is wrong, in English: "the line is too long for the control".
std::string_view wordingOf(ProgramProblem problem) noexcept;
/// The same, to be translated.
TextId textOf(ProgramProblem problem) noexcept;

/// Words of a program's line as a message may repeat them on a terminal, whatever bytes the program is of: UTF-8
/// without a byte that a terminal or a text view obeys. Such bytes, and those that are no UTF-8, stand as "\x1b". What
/// is longer than 40 characters is cut and ends in "…".
/// @param from @param length  bytes of the line; a character that begins within them is shown whole
std::string shownWords(std::string_view line, std::size_t from, std::size_t length);

} // namespace burin
