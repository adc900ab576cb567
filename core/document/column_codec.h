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

/// A table as columns of 64-bit words, the form in which recordings and meshes are packed. All columns have the same
/// length.
using Column = std::vector<std::uint64_t>;

/// Packs columns without loss. Each column is predicted from the previous row, from the two previous rows or from the
/// column `reference` positions before it, whichever leaves the smallest residuals; these are laid out byte plane by
/// byte plane and compressed.
/// @param reference number of columns to look back for the third prediction; 0: never. README.md describes the format.
std::string encodeColumns(const std::vector<Column>& columns, std::size_t reference = 0);

/// Empty if the bytes are damaged or don't hold exactly `columns` columns of `rows` words.
std::optional<std::vector<Column>> decodeColumns(std::string_view bytes, std::size_t columns, std::size_t rows);

/// Returns a word whose order is that of the numbers, so that neighbouring doubles differ little as words. Every bit
/// pattern has its own word, including NaNs and negative zero.
std::uint64_t wordOf(double value) noexcept;
/// The exact inverse of wordOf.
double doubleOf(std::uint64_t word) noexcept;

} // namespace burin
