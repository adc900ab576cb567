// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A position among evenly spaced knots: the cell in which it lies, and the values of its four basis functions there.
struct SplinePosition {
    std::size_t cell = 0;
    std::array<double, 4> values{};
};
/// @param share from the cell's knot to the next one, 0 … 1
SplinePosition splinePosition(std::size_t cell, double share) noexcept;

/// A cubic curve over evenly spaced knots, fitted to points with a penalty on the third differences of its coefficients
/// (P-spline: Eilers & Marx 1996). Linear time and memory.
class PenalisedSpline {
public:
    /// The number of coefficients of a curve with this last cell.
    static std::size_t sizeFor(std::size_t lastCell) noexcept { return lastCell + 4; }
    /// With unit weight for each unit of the parameter, the gain of the curve is 1 / (1 + (cut-off period / period)⁶).
    /// @param cutOffPeriod, gap between knots: both in the parameter's unit
    static double penaltyFor(double cutOffPeriod, double gap) noexcept;

    /// @param size number of coefficients, at least 4
    PenalisedSpline(std::size_t size, double penalty) : coefficients_(size), penalty_(penalty) {}

    /// @param at, points, weights of equal length; at least three positions with a weight above 0 differ
    void fit(std::span<const SplinePosition> at, std::span<const glm::dvec3> points, std::span<const double> weights);
    glm::dvec3 at(const SplinePosition& at) const noexcept;
    /// The derivative by the parameter, in lengths per gap.
    glm::dvec3 direction(std::size_t cell, double share) const noexcept;

private:
    std::vector<glm::dvec3> coefficients_;
    double penalty_;
};

} // namespace burin
