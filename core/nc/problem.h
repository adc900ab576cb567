// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace burin {

/// Problems in the text of a program, as reported by the parser and by lint.
enum class ProgramProblem : std::uint8_t {
    // the line itself
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
    // only from lint
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

/// Words of a program's line in a form that a message may repeat on a terminal, whatever the bytes of the program:
/// UTF-8 without control bytes that a terminal or a text view interprets. Such bytes, and those that are not UTF-8, are
/// shown as "\x1b". Text longer than 40 characters is cut and ends in "…".
/// @param from @param length bytes of the line; a character that begins within them is shown whole
std::string shownWords(std::string_view line, std::size_t from, std::size_t length);

} // namespace burin
