// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/penalised_spline.h"

#include "core/base/units.h"
#include "core/path/band_solver.h"

#include <algorithm>
#include <cmath>

namespace burin {

SplinePosition splinePosition(std::size_t cell, double share) noexcept {
    const double s = share, r = 1.0 - s;
    return {cell,
            {r * r * r / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, (3.0 * r * r * r - 6.0 * r * r + 4.0) / 6.0,
             s * s * s / 6.0}};
}

double PenalisedSpline::penaltyFor(double cutOffPeriod, double gap) noexcept {
    // The gain 1 / (1 + (f / fc)⁶) requires a penalty of (2 pi fc)⁻⁶ on the third derivative.
    return std::pow(cutOffPeriod / (2.0 * pi), 6.0) * std::pow(gap, -5.0);
}

void PenalisedSpline::fit(std::span<const SplinePosition> at, std::span<const glm::dvec3> points,
                          std::span<const double> weights) {
    BandMatrix matrix(coefficients_.size());
    std::ranges::fill(coefficients_, glm::dvec3(0.0));
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto& [cell, values] = at[k];
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j <= i; ++j) matrix.add(cell + i, cell + j, weights[k] * values[i] * values[j]);
            coefficients_[cell + i] += weights[k] * values[i] * points[k];
        }
    }
    constexpr std::array<double, 4> difference{-1.0, 3.0, -3.0, 1.0};
    for (std::size_t cell = 0; cell + 3 < coefficients_.size(); ++cell)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                matrix.add(cell + i, cell + j, penalty_ * difference[i] * difference[j]);
    matrix.solve(coefficients_);
}

glm::dvec3 PenalisedSpline::at(const SplinePosition& at) const noexcept {
    glm::dvec3 point(0.0);
    for (std::size_t i = 0; i < 4; ++i) point += at.values[i] * coefficients_[at.cell + i];
    return point;
}

glm::dvec3 PenalisedSpline::direction(std::size_t cell, double share) const noexcept {
    const double s = share, r = 1.0 - s;
    const std::array<double, 4> slopes{-0.5 * r * r, 1.5 * s * s - 2.0 * s, -1.5 * r * r + 2.0 * r, 0.5 * s * s};
    glm::dvec3 slope(0.0);
    for (std::size_t i = 0; i < 4; ++i) slope += slopes[i] * coefficients_[cell + i];
    return slope;
}

} // namespace burin
