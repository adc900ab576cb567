// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis.h"
#include "core/nc/problem.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace burin {

/// Modal groups of G words (NIST IR 6556, table 4): a block must not have two words of one group.
enum class GGroup : std::uint8_t {
    once, ///< not modal: G4 G10 G28 G30 G52 G53 G92 …
    motion,
    plane,
    distance,
    arcDistance,
    feedMode,
    units,
    compensation,
    lengthOffset,
    workOffset,
    control,
    retract,
    harmless, ///< switches off a function that Burin does not read: G50 G69
    smoothing,
    count
};
/// Modal groups of M words.
enum class MGroup : std::uint8_t { stop, toolChange, spindle, coolant, overrides, subprogram, count };

/// Ten times the numbers of the G words that the code refers to.
namespace gcode {
inline constexpr int rapid = 0, line = 10, clockwise = 20, anticlockwise = 30, dwell = 40, setOffset = 100;
inline constexpr int planeXY = 170, planeZX = 180, inch = 200;
inline constexpr int inchByG70 = 700;
inline constexpr int home = 280, storeHome = 281, secondHome = 300, storeSecondHome = 301;
inline constexpr int noCompensation = 400, lengthOffset = 430, statedLength = 431, noLengthOffset = 490;
inline constexpr int localShift = 520, machineFrame = 530, furtherOffset = 541;
inline constexpr int exactPath = 610, exactStop = 611, blend = 640, peckBreaking = 730, noMotion = 800,
                     absoluteCentres = 901;
inline constexpr int incremental = 910, shift = 920, dropShift = 921, pauseShift = 922;
inline constexpr int restoreShift = 923, inverseTime = 930, perRevolution = 950;
inline constexpr int retractToHeight = 990, furtherOffsetHaas = 1540;
} // namespace gcode

/// A word that occurs at most once in a block: letter and number.
struct Word {
    double value = 0.0;
    std::uint32_t column = 0; ///< of the letter, from 1; 0: the block has no such word
    bool point = false;       ///< its number has a decimal point, or comes from an expression
    bool given() const noexcept { return column != 0; }
};

/// A G or M word: ten times its number, so that G91.1 is 911.
struct Code {
    int number = -1; ///< -1: no word of the group
    std::uint32_t column = 0;
    bool given() const noexcept { return number >= 0; }
};

/// One line of a program, split into words but not yet executed.
struct Block {
    std::array<Word, 26> words{}; ///< by letter; G, M and N are not kept here
    std::array<Code, static_cast<std::size_t>(GGroup::count)> g{};
    std::array<Code, static_cast<std::size_t>(MGroup::count)> m{};
    std::uint32_t firstColumn = 0; ///< of its first word; 0: no word at all
    bool percent = false;          ///< the line is the tape mark %

    const Word& word(char letter) const noexcept { return words[static_cast<std::size_t>(letter - 'A')]; }
    const Word& word(Axis axis) const noexcept { return word(letterOf(axis)); }
    const Code& code(GGroup group) const noexcept { return g[static_cast<std::size_t>(group)]; }
    const Code& code(MGroup group) const noexcept { return m[static_cast<std::size_t>(group)]; }
    bool empty() const noexcept { return firstColumn == 0; }
    /// Whether any axis has a word.
    bool hasAxis() const noexcept {
        return std::ranges::any_of(axisLetters, [this](char letter) { return word(letter).given(); });
    }
    /// Whether any of I J K is given.
    bool hasOffset() const noexcept { return word('I').given() || word('J').given() || word('K').given(); }
    std::uint32_t firstAxis() const noexcept;   ///< column of the first word of an axis; 0: none
    std::uint32_t firstOffset() const noexcept; ///< column of the first of I J K; 0: none
};

/// What is wrong with a block, and where.
struct BlockFault {
    ProgramProblem problem = ProgramProblem::characterNotAllowed;
    std::uint32_t column = 1; ///< counted from 1
    std::uint32_t length = 1; ///< number of characters
    /// Lines that may be the cause; for an arc, those that set the two axes of its start; 0: none.
    std::array<std::uint32_t, 2> starts{};
    std::uint32_t incrementalSince = 0; ///< line of the G91 in force; 0: none, or not relevant
};

} // namespace burin
