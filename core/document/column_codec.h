// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A table by columns, each of 64-bit words: what recordings and meshes are packed as. All columns are equally long.
using Column = std::vector<std::uint64_t>;

/// Packs columns without loss. Each column is predicted from the row before, from the two rows before or from the
/// column in front of it by `reference` places, whichever leaves the least; what is left is laid out byte plane by byte
/// plane and compressed.
/// @param reference columns to look back for the third prediction; 0: never. README.md gives the form.
std::string encodeColumns(const std::vector<Column>& columns, std::size_t reference = 0);

/// Nothing when the bytes are damaged or don't hold exactly `columns` columns of `rows` words.
std::optional<std::vector<Column>> decodeColumns(std::string_view bytes, std::size_t columns, std::size_t rows);

/// Words in the order of the numbers that they stand for, so that neighbouring doubles differ little as words. Every
/// bit pattern has its own word, not-a-numbers and negative zero included.
std::uint64_t wordOf(double value) noexcept;
/// Back, to the bit.
double doubleOf(std::uint64_t word) noexcept;

} // namespace burin
