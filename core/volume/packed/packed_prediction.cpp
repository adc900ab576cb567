// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_prediction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace burin {

namespace {

using LineNumbers = std::array<std::int32_t, linesPerTile>;
constexpr std::size_t terms = Prediction::coefficientCount;

// Orthogonal over a whole tile.
constexpr std::array<std::int32_t, tileSide> linear{-7, -5, -3, -1, 1, 3, 5, 7};
constexpr std::array<std::int32_t, tileSide> square{7, 1, -3, -5, -5, -3, 1, 7};
/// Steps of each coefficient in 1/256 unit.
constexpr std::array<std::int32_t, terms> steps{1, 4, 4, 4, 1, 4};
/// Keeps the sum of all terms well within 32 bits.
constexpr double coefficientLimit = 1 << 22;
constexpr std::uint32_t spreadLimit = 1 << 21;

constexpr auto termValues = [] {
    std::array<std::array<double, linesPerTile>, terms> values{};
    for (std::size_t v = 0, line = 0; v < tileSide; ++v)
        for (std::size_t u = 0; u < tileSide; ++u, ++line) {
            const std::array<std::int32_t, terms> here{1,        linear[u], linear[v], square[u], linear[u] * linear[v],
                                                       square[v]};
            for (std::size_t k = 0; k < terms; ++k) values[k][line] = here[k];
        }
    return values;
}();

/// All terms on each scanline, in 1/256 unit, modulo 2^32.
void evaluateTerms(const std::array<std::int32_t, terms>& coefficients, TileValues& sums) noexcept {
    TileValues::value_type scaled[terms];
    for (std::size_t k = 0; k < terms; ++k)
        scaled[k] = static_cast<std::uint32_t>(coefficients[k]) * static_cast<std::uint32_t>(steps[k]);
    std::array<std::uint32_t, tileSide> bend{};
    for (std::size_t u = 0; u < tileSide; ++u) bend[u] = scaled[3] * static_cast<std::uint32_t>(square[u]);
    for (std::size_t v = 0; v < tileSide; ++v) {
        const auto atV = static_cast<std::uint32_t>(linear[v]);
        const std::uint32_t base = scaled[0] + scaled[2] * atV + scaled[5] * static_cast<std::uint32_t>(square[v]);
        const std::uint32_t slope = scaled[1] + scaled[4] * atV;
        std::uint32_t along = base - 7 * slope;
        for (std::size_t u = 0; u < tileSide; ++u, along += 2 * slope) sums[v * tileSide + u] = along + bend[u];
    }
}

} // namespace

void Prediction::evaluate(TileValues& expected) const noexcept {
    if (shape == PredictionShape::constant) {
        expected.fill(static_cast<std::uint32_t>(coefficients[0]) >> 8);
        return;
    }
    evaluateTerms(coefficients, expected);
    for (std::uint32_t& value : expected) value >>= 8;
}

PredictionFit::PredictionFit(std::span<const std::uint8_t> lines) noexcept {
    for (const std::uint8_t line : lines) present_[line] = ~std::uint32_t{0};
    if (lines.size() == linesPerTile) {
        static const std::array<Coefficients, size> whole = [] {
            std::array<Coefficients, size> factor{};
            for (std::size_t k = 0; k < size; ++k) {
                for (const double value : termValues[k]) factor[k][k] += value * value;
                factor[k][k] = std::sqrt(factor[k][k]);
            }
            return factor;
        }();
        factor_ = whole;
        determined_ = size;
    } else {
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k <= i; ++k)
                for (const std::uint8_t line : lines) factor_[i][k] += termValues[i][line] * termValues[k][line];
        factorise();
    }
    for (std::size_t k = 0; k < determined_; ++k) inverse_[k] = 1.0 / factor_[k][k];
}

void PredictionFit::factorise() noexcept {
    for (; determined_ < size; ++determined_) {
        Coefficients& row = factor_[determined_];
        const double before = row[determined_];
        for (std::size_t k = 0; k < determined_; ++k) {
            for (std::size_t m = 0; m < k; ++m) row[k] -= row[m] * factor_[k][m];
            row[k] /= factor_[k][k];
            row[determined_] -= row[k] * row[k];
        }
        if (row[determined_] <= 1e-9 * before) return; // not independent of the terms before, on these scanlines
        row[determined_] = std::sqrt(row[determined_]);
    }
}

void PredictionFit::solve(std::size_t count, Coefficients& values) const noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) values[i] -= factor_[i][k] * values[k];
        values[i] *= inverse_[i];
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t k = i + 1; k < count; ++k) values[i] -= factor_[k][i] * values[k];
        values[i] *= inverse_[i];
    }
}

void PredictionFit::set(const TileValues& values) noexcept {
    std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max(), highest = 0;
    for (std::size_t line = 0; line < linesPerTile; ++line) {
        lowest = std::min(lowest, values[line] | ~present_[line]);
        highest = std::max(highest, values[line] & present_[line]);
    }
    lowest_ = lowest;
    spread_ = highest - lowest;
    for (std::size_t line = 0; line < linesPerTile; ++line)
        from_[line] = static_cast<std::int32_t>((values[line] - lowest) & present_[line]);
}

bool PredictionFit::fit(PredictionShape shape, Prediction& prediction, unsigned& width) const noexcept {
    prediction = {shape, {}};
    if (shape == PredictionShape::constant) {
        prediction.coefficients[0] = static_cast<std::int32_t>(lowest_ << 8);
        width = static_cast<unsigned>(std::bit_width(spread_));
        return true;
    }
    const std::size_t count = Prediction::countOf(shape);
    if (count > determined_ || spread_ >= spreadLimit) return false;
    Coefficients sums{};
    for (std::size_t k = 0; k < count; ++k) {
        // Four sums side by side, so that the additions of one do not wait for each other.
        std::array<double, 4> parts{};
        for (std::size_t line = 0; line < linesPerTile; line += parts.size())
            for (std::size_t part = 0; part < parts.size(); ++part)
                parts[part] += termValues[k][line + part] * from_[line + part];
        sums[k] = (parts[0] + parts[1]) + (parts[2] + parts[3]);
    }
    solve(count, sums);
    for (std::size_t k = 1; k < count; ++k) {
        const double coefficient = std::floor(sums[k] * (256.0 / steps[k]) + 0.5);
        if (!(std::abs(coefficient) < coefficientLimit)) return false;
        prediction.coefficients[k] = static_cast<std::int32_t>(coefficient);
    }
    TileValues slopes;
    evaluateTerms(prediction.coefficients, slopes);
    std::int32_t lowest = std::numeric_limits<std::int32_t>::max(), highest = std::numeric_limits<std::int32_t>::min();
    for (std::size_t line = 0; line < linesPerTile; ++line) {
        const std::int32_t above = from_[line] * 256 + 255 - static_cast<std::int32_t>(slopes[line]);
        const auto counts = static_cast<std::int32_t>(present_[line]);
        lowest = std::min(lowest, (above & counts) | (std::numeric_limits<std::int32_t>::max() & ~counts));
        highest = std::max(highest, (above & counts) | (std::numeric_limits<std::int32_t>::min() & ~counts));
    }
    const std::int64_t place = std::int64_t{lowest_} * 256 + lowest;
    if (std::abs(place) > std::numeric_limits<std::int32_t>::max()) return false;
    prediction.coefficients[0] = static_cast<std::int32_t>(place);
    width = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(highest - lowest) >> 8));
    return true;
}

} // namespace burin
