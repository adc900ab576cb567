// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"

#include <array>
#include <cstdint>
#include <span>

namespace burin {

/// Predicted shape over the tile of the values of one column (one run end of many scanlines of a tile).
enum class PredictionShape : std::uint8_t { constant, plane, quadratic };

/// One value per scanline of a tile.
using TileValues = std::array<std::uint32_t, linesPerTile>;

/// A function of a scanline's position in its tile, in integer arithmetic only, so that every machine gets the same
/// result: with U = 2u - 7, V = 2v - 7 and Q(x) = (x² - 21) / 4,
/// (c0 + 4 (c1 U + c2 V) + 4 (c3 Q(U) + c5 Q(V)) + c4 U V) / 256, rounded down, modulo 2^24.
struct Prediction {
    static constexpr std::size_t coefficientCount = 6;
    PredictionShape shape = PredictionShape::constant;
    std::array<std::int32_t, coefficientCount> coefficients{};

    /// Number of coefficients of a shape: 1, 3 or 6; the others are 0.
    static constexpr std::size_t countOf(PredictionShape shape) noexcept {
        return shape == PredictionShape::constant ? 1 : shape == PredictionShape::plane ? 3 : 6;
    }
    /// The predicted value on each scanline of the tile.
    void evaluate(TileValues& expected) const noexcept;
};
inline constexpr std::uint32_t predictionMask = 0xffffff;

/// Fits shapes to the values of one column by least squares, for some of the scanlines of a tile.
class PredictionFit {
public:
    /// @param lines  indices of the scanlines in their tile, 8 v + u, rising; at least one
    explicit PredictionFit(std::span<const std::uint8_t> lines) noexcept;

    /// Sets the values of the next column, below 2^24, by index in the tile; those of other scanlines are not used.
    void set(const TileValues& values) noexcept;
    /// Fits a shape to these values, shifted along the runs so that no value lies below its prediction and as many as
    /// possible equal it. False if the scanlines are too few to determine the shape, or its coefficients are out of
    /// range.
    /// @param width  receives the bits per residual
    bool fit(PredictionShape shape, Prediction& prediction, unsigned& width) const noexcept;

private:
    static constexpr std::size_t size = Prediction::coefficientCount;
    using Coefficients = std::array<double, size>;

    void factorise() noexcept;
    void solve(std::size_t count, Coefficients& values) const noexcept;

    TileValues present_{};                          ///< all bits set for scanlines that are used
    std::array<Coefficients, size> factor_{};       ///< lower triangle (Cholesky) of the normal equations
    Coefficients inverse_{};                        ///< of the factor's diagonal
    std::size_t determined_ = 0;                    ///< number of coefficients that the scanlines determine
    std::array<std::int32_t, linesPerTile> from_{}; ///< values minus the lowest; 0 for scanlines that are not used
    std::uint32_t lowest_ = 0, spread_ = 0;
};

} // namespace burin
