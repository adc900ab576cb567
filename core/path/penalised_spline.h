// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A position among evenly spaced knots: between which two it lies, and what the four coefficients there count.
struct SplinePosition {
    std::size_t cell = 0;
    std::array<double, 4> values{};
};
/// @param share of the way from the cell's knot to the next one, 0 … 1
SplinePosition splinePosition(std::size_t cell, double share) noexcept;

/// A cubic curve over evenly spaced knots, fitted to points with a penalty on the third differences of its coefficients
/// (P-spline: Eilers & Marx 1996). Linear time and memory.
class PenalisedSpline {
public:
    /// Cells that a curve over so many knots has coefficients for.
    static std::size_t sizeFor(std::size_t lastCell) noexcept { return lastCell + 4; }
    /// With unit weight for each unit of the parameter, the curve keeps 1 / (1 + (cut-off period / period)⁶).
    /// @param cutOffPeriod, gap between knots: both in the parameter's unit
    static double penaltyFor(double cutOffPeriod, double gap) noexcept;

    /// @param size coefficients, at least 4
    PenalisedSpline(std::size_t size, double penalty) : coefficients_(size), penalty_(penalty) {}

    /// @param at, points, weights of one length; three of the positions at least differ, with a weight above 0
    void fit(std::span<const SplinePosition> at, std::span<const glm::dvec3> points, std::span<const double> weights);
    glm::dvec3 at(const SplinePosition& at) const noexcept;
    /// Along the parameter, in lengths a gap.
    glm::dvec3 direction(std::size_t cell, double share) const noexcept;

private:
    std::vector<glm::dvec3> coefficients_;
    double penalty_;
};

} // namespace burin
