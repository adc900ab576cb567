// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/tile.h"

#include <array>
#include <cstdint>
#include <span>

namespace burin {

/// How the values of one column (one run end of many scanlines of a tile) are expected to lie over the tile.
enum class PredictionShape : std::uint8_t { constant, plane, quadratic };

/// A function of a scanline's place in its tile, in whole numbers alone, so that every machine finds the same: with
/// U = 2u - 7, V = 2v - 7 and Q(x) = (x² - 21) / 4,
/// (c0 + 4 (c1 U + c2 V) + 4 (c3 Q(U) + c5 Q(V)) + c4 U V) / 256, rounded down, modulo 2^24.
struct Prediction {
    static constexpr std::size_t coefficientCount = 6;
    PredictionShape shape = PredictionShape::constant;
    std::array<std::int32_t, coefficientCount> coefficients{};

    /// Coefficients that a shape has: 1, 3 or 6; the others are 0.
    static constexpr std::size_t countOf(PredictionShape shape) noexcept {
        return shape == PredictionShape::constant ? 1 : shape == PredictionShape::plane ? 3 : 6;
    }
    /// What is expected on each scanline of the tile.
    void evaluate(std::array<std::uint32_t, linesPerTile>& expected) const noexcept;
};
inline constexpr std::uint32_t predictionMask = 0xffffff;

/// Fits shapes to values on some scanlines of a tile by least squares. One object for all columns of these scanlines.
class PredictionFit {
public:
    /// @param lines places of the scanlines in their tile, 8 v + u, rising
    explicit PredictionFit(std::span<const std::uint8_t> lines) noexcept;

    /// The fit of a shape, moved along the runs so that nothing lies below what is expected and as much as possible
    /// lies on it. False: so few scanlines don't determine it, or its numbers are out of reach.
    /// @param values one a scanline, below 2^24
    bool fit(PredictionShape shape, std::span<const std::uint32_t> values, Prediction& prediction) const noexcept;

private:
    static constexpr std::size_t size = Prediction::coefficientCount;
    void solve(std::size_t count, std::array<double, size>& values) const noexcept;

    std::span<const std::uint8_t> lines_;
    std::array<std::array<double, size>, size> factor_{}; ///< lower triangle (Cholesky) of the normal equations
    std::size_t determined_ = 0;                          ///< coefficients that the scanlines determine
};

} // namespace burin
