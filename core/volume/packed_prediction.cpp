// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed_prediction.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace burin {

namespace {

// Orthogonal over a whole tile.
constexpr std::array<std::int32_t, tileSide> linear{-7, -5, -3, -1, 1, 3, 5, 7};
constexpr std::array<std::int32_t, tileSide> square{7, 1, -3, -5, -5, -3, 1, 7};
/// Steps of each coefficient in 1/256 unit.
constexpr std::array<std::int32_t, Prediction::coefficientCount> steps{1, 4, 4, 4, 1, 4};

constexpr std::array<std::int32_t, Prediction::coefficientCount> termsAt(int line) {
    const auto u = static_cast<std::size_t>(line % tileSide), v = static_cast<std::size_t>(line / tileSide);
    return {1, linear[u], linear[v], square[u], linear[u] * linear[v], square[v]};
}

constexpr auto allTerms = [] {
    std::array<std::array<std::int32_t, linesPerTile>, Prediction::coefficientCount> terms{};
    for (int line = 0; line < linesPerTile; ++line)
        for (std::size_t k = 0; k < terms.size(); ++k) terms[k][static_cast<std::size_t>(line)] = termsAt(line)[k];
    return terms;
}();

constexpr std::int32_t coefficientLimit = 1 << 22;

} // namespace

void Prediction::evaluate(std::array<std::uint32_t, linesPerTile>& expected) const noexcept {
    std::array<std::uint32_t, coefficientCount> scaled{};
    for (std::size_t k = 0; k < coefficientCount; ++k)
        scaled[k] = static_cast<std::uint32_t>(coefficients[k]) * static_cast<std::uint32_t>(steps[k]);
    for (std::size_t v = 0, line = 0; v < tileSide; ++v) {
        const auto atV = static_cast<std::uint32_t>(linear[v]);
        const std::uint32_t base = scaled[0] + scaled[2] * atV + scaled[5] * static_cast<std::uint32_t>(square[v]);
        const std::uint32_t slope = scaled[1] + scaled[4] * atV;
        for (std::size_t u = 0; u < tileSide; ++u, ++line)
            expected[line] = (base + slope * static_cast<std::uint32_t>(linear[u]) +
                              scaled[3] * static_cast<std::uint32_t>(square[u])) >>
                             8;
    }
}

PredictionFit::PredictionFit(std::span<const std::uint8_t> lines) noexcept : lines_(lines) {
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            std::int32_t sum = 0;
            for (const std::uint8_t line : lines) sum += allTerms[i][line] * allTerms[k][line];
            factor_[i][k] = sum;
        }
    for (determined_ = 0; determined_ < size; ++determined_) {
        auto& row = factor_[determined_];
        const double before = row[determined_];
        for (std::size_t k = 0; k < determined_; ++k) {
            for (std::size_t m = 0; m < k; ++m) row[k] -= row[m] * factor_[k][m];
            row[k] /= factor_[k][k];
            row[determined_] -= row[k] * row[k];
        }
        if (row[determined_] <= 1e-9 * before) break; // these scanlines can't tell it from the terms before it
        row[determined_] = std::sqrt(row[determined_]);
    }
}

void PredictionFit::solve(std::size_t count, std::array<double, size>& values) const noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) values[i] -= factor_[i][k] * values[k];
        values[i] /= factor_[i][i];
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t k = i + 1; k < count; ++k) values[i] -= factor_[k][i] * values[k];
        values[i] /= factor_[i][i];
    }
}

bool PredictionFit::fit(PredictionShape shape, std::span<const std::uint32_t> values,
                        Prediction& prediction) const noexcept {
    const std::size_t count = Prediction::countOf(shape);
    if (count > determined_) return false;
    prediction = {shape, {}};
    if (count > 1) {
        std::array<double, size> sums{};
        for (std::size_t k = 0; k < count; ++k) {
            std::int64_t sum = 0;
            for (std::size_t i = 0; i < values.size(); ++i) sum += std::int64_t{allTerms[k][lines_[i]]} * values[i];
            sums[k] = static_cast<double>(sum);
        }
        solve(count, sums);
        for (std::size_t k = 1; k < count; ++k) {
            const double coefficient = std::floor(sums[k] * 256.0 / steps[k] + 0.5);
            if (!(std::abs(coefficient) < coefficientLimit)) return false;
            prediction.coefficients[k] = static_cast<std::int32_t>(coefficient);
        }
    }
    std::int64_t highest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::int64_t slope = 0;
        for (std::size_t k = 1; k < count; ++k)
            slope += std::int64_t{prediction.coefficients[k]} * steps[k] * allTerms[k][lines_[i]];
        highest = std::min(highest, std::int64_t{values[i]} * 256 + (count > 1 ? 255 : 0) - slope);
    }
    if (std::abs(highest) > std::numeric_limits<std::int32_t>::max()) return false;
    prediction.coefficients[0] = static_cast<std::int32_t>(highest);
    return true;
}

} // namespace burin
