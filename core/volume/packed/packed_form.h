// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/packed/bit_stream.h"
#include "core/volume/packed/packed_prediction.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

/// Parts of a packed tile that its writer and its reader share (volume_file.md, "A packed brick").
namespace burin::packed_form {

inline constexpr unsigned shapeWidth = 2, widthWidth = 5;
/// Bit widths of the fields that hold the widths of the three kinds of coefficients: place, slopes, bends.
inline constexpr unsigned placeWidthWidth = 6, slopeWidthWidth = 5;
inline constexpr std::uint32_t shortPalette = 32; ///< property lists up to this size: one bit per entry

inline unsigned bitsFor(std::size_t choices) noexcept {
    return static_cast<unsigned>(std::bit_width(choices - 1));
}
inline unsigned groupWidth(std::size_t groups) noexcept {
    return bitsFor(groups);
}
inline unsigned firstRankWidth(std::size_t palette) noexcept {
    return bitsFor(palette);
}
/// Neighbours differ, so there is one choice fewer.
inline unsigned nextRankWidth(std::size_t palette) noexcept {
    return palette < 2 ? 0 : bitsFor(palette - 1);
}
inline unsigned columnHeadBits(std::size_t column) noexcept {
    return shapeWidth + widthWidth + (column > 0 ? 1 : 0);
}
/// The minimum size of a column.
inline constexpr std::uint64_t leastColumnBits = shapeWidth + widthWidth + placeWidthWidth;

/// Maps numbers of either sign to unsigned ones, small values to small values.
inline std::uint32_t folded(std::int32_t number) noexcept {
    return (static_cast<std::uint32_t>(number) << 1) ^ static_cast<std::uint32_t>(number >> 31);
}
inline std::int32_t unfolded(std::uint32_t word) noexcept {
    return static_cast<std::int32_t>((word >> 1) ^ (0 - (word & 1)));
}

/// Number of bits of a prediction's coefficients, as `writeCoefficients` writes them.
std::uint64_t coefficientBits(const Prediction& prediction) noexcept;
void writeCoefficients(const Prediction& prediction, BitWriter& writer);
void readCoefficients(Prediction& prediction, BitReader& reader) noexcept;

void writePalette(std::span<const PropertyIndex> palette, std::uint32_t properties, BitWriter& writer);
/// The palette is empty if the bytes are damaged.
void readPalette(std::pmr::vector<PropertyIndex>& palette, std::uint32_t properties, BitReader& reader);

} // namespace burin::packed_form
