// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace burin {

/// Modal groups of G words (RS274/NGC, table 4): two words of one group can't stand in one block.
enum class GGroup : std::uint8_t {
    dwell,
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
    count
};
/// Modal groups of M words.
enum class MGroup : std::uint8_t { stop, toolChange, spindle, coolant, count };

/// A word that stands alone in its block: letter and number.
struct Word {
    double value = 0.0;
    std::uint32_t column = 0; ///< of the letter, from 1; 0: the block has no such word
    bool given() const noexcept { return column != 0; }
};

/// A G or M word: ten times its number, so that G91.1 is 911.
struct Code {
    int number = -1; ///< -1: none of its group
    std::uint32_t column = 0;
    bool given() const noexcept { return number >= 0; }
};

/// One line of a program, taken apart but not yet carried out.
struct Block {
    std::array<Word, 26> words{}; ///< by letter; G, M and N are not kept here
    std::array<Code, static_cast<std::size_t>(GGroup::count)> g{};
    std::array<Code, static_cast<std::size_t>(MGroup::count)> m{};
    std::uint32_t firstColumn = 0; ///< of its first word; 0: no word at all
    bool percent = false;          ///< the line is the tape mark %

    const Word& word(char letter) const noexcept { return words[static_cast<std::size_t>(letter - 'A')]; }
    const Code& code(GGroup group) const noexcept { return g[static_cast<std::size_t>(group)]; }
    const Code& code(MGroup group) const noexcept { return m[static_cast<std::size_t>(group)]; }
    bool empty() const noexcept { return firstColumn == 0; }
    /// Any of X Y Z.
    bool hasAxis() const noexcept { return word('X').given() || word('Y').given() || word('Z').given(); }
    /// Any of I J K.
    bool hasOffset() const noexcept { return word('I').given() || word('J').given() || word('K').given(); }
};

/// What is wrong with a block: where and which word.
struct BlockFault {
    std::uint32_t column = 0; ///< from 1
    std::string_view reason;  ///< a literal
    std::string_view text;    ///< the words concerned, out of the program
};

/// Takes one line apart. Comments are left out, letters may be of either case, blanks may stand between words and
/// between a letter and its number, but not inside a number. A block behind / is read as if block delete were off.
/// @return true, or false and `fault` filled
bool readBlock(std::string_view line, Block& block, BlockFault& fault) noexcept;

} // namespace burin
