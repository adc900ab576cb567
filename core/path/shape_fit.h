// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"
#include "core/path/penalised_spline.h"

#include <span>
#include <vector>

namespace burin {

/// A curve by its own length, fitted to a stroke's points and to the moves between them. They count by the progress of
/// the course without tremor: a hand that rests says hardly more about the shape than one that passes, and within a
/// wave of tremor all points count alike. By their own length those would count more where tremor hurries the hand on,
/// and the mean of a wave would not be its middle.
class ShapeFit {
public:
    /// @param course mm, of each point, never falling; the first is 0 @param wavelength cut-off, mm
    /// @param gap between knots, mm
    ShapeFit(std::span<const StrokePoint> points, std::span<const double> course, double wavelength, double gap);

    void fit() { spline_.fit(at_, tips_, weights_); }
    /// The curve at a point's length, mm.
    glm::dvec3 tip(std::size_t point) const noexcept { return spline_.at(at_[pointAt_[point]]); }
    /// Unit; zero where the curve stands.
    glm::dvec3 direction(std::size_t point) const noexcept;
    /// A point counts so many times as much as before.
    void weigh(std::size_t point, double times) noexcept;
    /// The curve goes through a point.
    void pin(std::size_t point) noexcept;

private:
    void add(double course, const glm::dvec3& tip, double weight);

    double gap_; // mm
    PenalisedSpline spline_;
    std::vector<SplinePosition> at_; // of the points and of what stands between them
    std::vector<double> shares_, weights_;
    std::vector<glm::dvec3> tips_;
    std::vector<std::size_t> pointAt_;
};

/// Lengths along a curve that a first, coarse course led to: mm, one a point, never falling; the first is 0.
std::vector<double> courseAlong(const ShapeFit& fit, std::span<const StrokePoint> points);

} // namespace burin
