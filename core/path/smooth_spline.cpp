// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/path/apply.h"
#include "core/path/band_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

/// Knots in a period of the cut-off: dense enough to go round corners where the tube demands it.
constexpr double knotsPerPeriod = 40.0;
/// So often points that left the tube get more weight. What is still outside then is put onto its wall.
constexpr int rounds = 16;
/// Aimed at, as a share of the tolerance.
constexpr double aim = 0.97;
constexpr double heaviest = 1e7;

/// Uniform cubic B-splines over a place between two knots, 0 … 1.
std::array<double, 4> basis(double s) noexcept {
    const double r = 1.0 - s;
    return {r * r * r / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, (3.0 * r * r * r - 6.0 * r * r + 4.0) / 6.0,
            s * s * s / 6.0};
}

/// A spline in time through evenly timed points (Eilers & Marx 1996: B-splines with a penalty on differences of their
/// coefficients).
class PenalisedSpline {
public:
    PenalisedSpline(const PathStroke& stroke, double cutOff)
        : points_(stroke.points)
        , perKnot_(
              std::max<std::size_t>(1, static_cast<std::size_t>(1.0 / (knotsPerPeriod * cutOff * stroke.tickPeriod))))
        , size_((stroke.points.size() - 1) / perKnot_ + BandMatrix::width) {
        // Gain 1 / (1 + (f / fc)⁶) asks for a penalty of (2 pi fc)⁻⁶ on the third derivative.
        const double gap = static_cast<double>(perKnot_) * stroke.tickPeriod;
        penalty_ = std::pow(2.0 * pi * cutOff, -6.0) * std::pow(gap, -5.0) / stroke.tickPeriod;
    }

    /// The spline at each point's time. @param weights of the points
    std::vector<glm::dvec3> fitted(const std::vector<double>& weights) const {
        BandMatrix matrix(size_);
        std::vector<glm::dvec3> coefficients(size_, glm::dvec3(0.0));
        for (std::size_t k = 0; k < points_.size(); ++k) {
            const auto [cell, values] = at(k);
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j <= i; ++j) matrix.add(cell + i, cell + j, weights[k] * values[i] * values[j]);
                coefficients[cell + i] += weights[k] * values[i] * points_[k].tip;
            }
        }
        constexpr std::array<double, 4> difference{-1.0, 3.0, -3.0, 1.0};
        for (std::size_t cell = 0; cell + 3 < size_; ++cell)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j <= i; ++j)
                    matrix.add(cell + i, cell + j, penalty_ * difference[i] * difference[j]);
        matrix.solve(coefficients);
        std::vector<glm::dvec3> tips(points_.size(), glm::dvec3(0.0));
        for (std::size_t k = 0; k < tips.size(); ++k) {
            const auto [cell, values] = at(k);
            for (std::size_t i = 0; i < 4; ++i) tips[k] += values[i] * coefficients[cell + i];
        }
        return tips;
    }

private:
    struct Place {
        std::size_t cell;
        std::array<double, 4> values;
    };
    Place at(std::size_t k) const noexcept {
        return {k / perKnot_, basis(static_cast<double>(k % perKnot_) / static_cast<double>(perKnot_))};
    }

    const std::vector<StrokePoint>& points_;
    std::size_t perKnot_, size_;
    double penalty_ = 0.0;
};

/// Both polylines have a corner at each tick, so that no place of one is farther from the other than the ticks are.
Deviation smooth(PathStroke& stroke, const SmoothSpline& edit, const Progress& progress) {
    Deviation deviation;
    std::vector<StrokePoint>& points = stroke.points;
    if (points.size() < BandMatrix::width) return deviation;
    const PenalisedSpline spline(stroke, edit.cutOff);
    std::vector<double> weights(points.size(), 1.0);
    std::vector<glm::dvec3> tips;
    for (int round = 0; round <= rounds && !progress.cancelled(); ++round) {
        tips = spline.fitted(weights);
        bool within = true;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double off = glm::distance(tips[k], points[k].tip);
            if (off <= edit.tolerance) continue;
            within = false;
            const double times = edit.tolerance > 0.0 ? off / (aim * edit.tolerance) : heaviest;
            weights[k] = std::min(heaviest, weights[k] * times * times);
        }
        if (within) break;
    }
    if (progress.cancelled()) return deviation;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const glm::dvec3 shift = clampLength(tips[k] - points[k].tip, edit.tolerance);
        points[k].tip += shift;
        deviation.include(glm::length(shift), points[k].tip);
    }
    return deviation;
}

} // namespace

Result<Deviation> apply(const SmoothSpline& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    if (Result<void> usable = checkCutOff(edit.cutOff, state); !usable) return usable.error();
    return changeEach(state, progress, [&](PathStroke& stroke) { return smooth(stroke, edit, progress); });
}

} // namespace burin
