// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/block.h"

namespace burin {
namespace {

std::uint32_t firstOf(const Block& block, std::string_view letters) noexcept {
    std::uint32_t column = 0;
    for (const char letter : letters) {
        const Word& word = block.word(letter);
        if (word.given() && (column == 0 || word.column < column)) column = word.column;
    }
    return column;
}

} // namespace

std::uint32_t Block::firstAxis() const noexcept {
    return firstOf(*this, axisLetters);
}

std::uint32_t Block::firstOffset() const noexcept {
    return firstOf(*this, "IJK");
}

} // namespace burin
