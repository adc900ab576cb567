// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/column_codec.h"

#include "core/base/compression.h"

#include <bit>

namespace burin {

namespace {

constexpr std::uint64_t signBit = std::uint64_t{1} << 63;
constexpr std::size_t columnWordBytes = 8;

// The first byte of a packed column. A value n >= columnBefore refers to the column n - columnBefore + 1 positions
// before.
enum Prediction : unsigned char { rowBefore = 0, straightOn = 1, columnBefore = 2 };

/// Maps differences of either sign to unsigned words; small differences give small words.
std::uint64_t folded(std::uint64_t difference) noexcept {
    return (difference << 1) ^ (0 - (difference >> 63));
}
std::uint64_t unfolded(std::uint64_t word) noexcept {
    return (word >> 1) ^ (0 - (word & 1));
}

/// Returns the prediction for `row`, computed only from words that the reader has already decoded.
std::uint64_t predicted(unsigned char prediction, const Column& column, const Column* reference, std::size_t row) {
    if (prediction >= columnBefore) return (*reference)[row];
    if (row == 0) return 0;
    if (prediction == rowBefore || row == 1) return column[row - 1];
    return 2 * column[row - 1] - column[row - 2];
}

Column differences(unsigned char prediction, const Column& column, const Column* reference) {
    Column result(column.size());
    for (std::size_t row = 0; row < column.size(); ++row)
        result[row] = folded(column[row] - predicted(prediction, column, reference, row));
    return result;
}

std::size_t significantBits(const Column& column) {
    std::size_t bits = 0;
    for (const std::uint64_t word : column) bits += static_cast<std::size_t>(std::bit_width(word));
    return bits;
}

void appendPlanes(std::string& bytes, const Column& words) {
    for (std::size_t plane = 0; plane < columnWordBytes; ++plane)
        for (const std::uint64_t word : words) bytes.push_back(static_cast<char>((word >> (8 * plane)) & 0xff));
}

Column wordsOfPlanes(std::string_view planes, std::size_t rows) {
    Column words(rows);
    for (std::size_t plane = 0; plane < columnWordBytes; ++plane)
        for (std::size_t row = 0; row < rows; ++row) {
            const auto byte = static_cast<unsigned char>(planes[plane * rows + row]);
            words[row] |= std::uint64_t{byte} << (8 * plane);
        }
    return words;
}

void appendColumn(std::string& bytes, const Column& column, const Column* reference, std::size_t referenceDistance) {
    auto best = static_cast<unsigned char>(rowBefore);
    Column least = differences(best, column, nullptr);
    std::size_t leastBits = significantBits(least);
    const auto consider = [&](unsigned char prediction, const Column* from) {
        Column other = differences(prediction, column, from);
        const std::size_t bits = significantBits(other);
        if (bits >= leastBits) return;
        best = prediction;
        least = std::move(other);
        leastBits = bits;
    };
    consider(straightOn, nullptr);
    if (reference != nullptr) consider(static_cast<unsigned char>(columnBefore + referenceDistance - 1), reference);
    bytes.push_back(static_cast<char>(best));
    appendPlanes(bytes, least);
}

} // namespace

std::string encodeColumns(const std::vector<Column>& columns, std::size_t reference) {
    std::string bytes;
    if (!columns.empty()) bytes.reserve(columns.size() * (1 + columnWordBytes * columns.front().size()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Column* before = reference > 0 && i >= reference ? &columns[i - reference] : nullptr;
        appendColumn(bytes, columns[i], before, reference);
    }
    return compress(bytes);
}

std::optional<std::vector<Column>> decodeColumns(std::string_view bytes, std::size_t columns, std::size_t rows) {
    const std::size_t most = mostUnpacked(bytes.size());
    if (rows > most / columnWordBytes) return std::nullopt; // no product below overflows
    const std::size_t columnSize = 1 + columnWordBytes * rows;
    if (columns * columnSize > most) return std::nullopt;
    const std::optional<std::string> plain = decompress(bytes, columns * columnSize);
    if (!plain || plain->size() != columns * columnSize) return std::nullopt;
    std::vector<Column> result;
    for (std::size_t i = 0; i < columns; ++i) {
        const std::string_view packed = std::string_view(*plain).substr(i * columnSize, columnSize);
        const auto prediction = static_cast<unsigned char>(packed.front());
        const Column* reference = nullptr;
        if (prediction >= columnBefore) {
            const std::size_t distance = prediction - std::size_t{columnBefore} + 1;
            if (distance > i) return std::nullopt;
            reference = &result[i - distance];
        }
        Column column = wordsOfPlanes(packed.substr(1), rows);
        for (std::size_t row = 0; row < rows; ++row)
            column[row] = unfolded(column[row]) + predicted(prediction, column, reference, row);
        result.push_back(std::move(column));
    }
    return result;
}

std::uint64_t wordOf(double value) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return (bits & signBit) != 0 ? ~bits : bits | signBit;
}

double doubleOf(std::uint64_t word) noexcept {
    return std::bit_cast<double>((word & signBit) != 0 ? word & ~signBit : ~word);
}

} // namespace burin
