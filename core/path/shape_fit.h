// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"
#include "core/path/penalised_spline.h"

#include <span>
#include <vector>

namespace burin {

/// A curve over its own arc length, fitted to a stroke's points and to the moves between them. They are weighted by the
/// progress of the course without tremor: a resting hand says hardly more about the shape than one that passes, and
/// within a wave of tremor all points have the same weight. Weighted by their own length, points would count more where
/// tremor speeds the hand up, and the mean of a wave would not be its middle.
class ShapeFit {
public:
    /// @param course mm, of each point, non-decreasing; the first is 0 @param wavelength cut-off, mm
    /// @param gap between knots, mm
    ShapeFit(std::span<const StrokePoint> points, std::span<const double> course, double wavelength, double gap);

    void fit() { spline_.fit(at_, tips_, weights_); }
    /// The point of the curve at the course of a point, mm.
    glm::dvec3 tip(std::size_t point) const noexcept { return spline_.at(at_[pointAt_[point]]); }
    /// Unit length; zero where the curve does not advance.
    glm::dvec3 direction(std::size_t point) const noexcept;
    /// Multiplies the weight of a point.
    void weigh(std::size_t point, double times) noexcept;
    /// Makes the curve pass through a point.
    void pin(std::size_t point) noexcept;

private:
    void add(double course, const glm::dvec3& tip, double weight);

    double gap_; // mm
    PenalisedSpline spline_;
    std::vector<SplinePosition> at_; // of the points and of the samples between them
    std::vector<double> shares_, weights_;
    std::vector<glm::dvec3> tips_;
    std::vector<std::size_t> pointAt_;
};

/// Lengths along a curve that was fitted with a first, coarse course: mm, one per point, non-decreasing; the first is
/// 0.
std::vector<double> courseAlong(const ShapeFit& fit, std::span<const StrokePoint> points);

} // namespace burin
