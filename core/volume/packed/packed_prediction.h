// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"

#include <array>
#include <cstdint>
#include <span>

namespace burin {

/// How the values of one column (one run end of many scanlines of a tile) are expected to lie over the tile.
enum class PredictionShape : std::uint8_t { constant, plane, quadratic };

/// One value for each scanline of a tile.
using TileValues = std::array<std::uint32_t, linesPerTile>;

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
    void evaluate(TileValues& expected) const noexcept;
};
inline constexpr std::uint32_t predictionMask = 0xffffff;

/// Fits shapes to the values of one column by least squares, on some scanlines of a tile.
class PredictionFit {
public:
    /// @param lines places of the scanlines in their tile, 8 v + u, rising; at least one
    explicit PredictionFit(std::span<const std::uint8_t> lines) noexcept;

    /// Takes the values of the next column, below 2^24, by place in the tile; those of other scanlines are not used.
    void set(const TileValues& values) noexcept;
    /// The fit of a shape to these values, moved along the runs so that nothing lies below what is expected and as much
    /// as possible lies on it. False: so few scanlines don't determine it, or its numbers are out of reach.
    /// @param width bits of what the prediction leaves
    bool fit(PredictionShape shape, Prediction& prediction, unsigned& width) const noexcept;

private:
    static constexpr std::size_t size = Prediction::coefficientCount;
    using Coefficients = std::array<double, size>;

    void factorise() noexcept;
    void solve(std::size_t count, Coefficients& values) const noexcept;

    TileValues present_{};                          ///< all bits set for scanlines that count
    std::array<Coefficients, size> factor_{};       ///< lower triangle (Cholesky) of the normal equations
    Coefficients inverse_{};                        ///< of the factor's diagonal
    std::size_t determined_ = 0;                    ///< coefficients that the scanlines determine
    std::array<std::int32_t, linesPerTile> from_{}; ///< values less the lowest; 0 for scanlines that don't count
    std::uint32_t lowest_ = 0, spread_ = 0;
};

} // namespace burin
