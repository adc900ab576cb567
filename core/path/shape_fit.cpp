// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/shape_fit.h"

#include "core/path/shape_course.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Weights, mm of the course: lower and upper limit for a point that leaves the tube.
constexpr double leastWeight = 1e-3, mostWeight = 1e6;

} // namespace

ShapeFit::ShapeFit(std::span<const StrokePoint> points, std::span<const double> course, double wavelength, double gap)
    : gap_(gap)
    , spline_(PenalisedSpline::sizeFor(static_cast<std::size_t>(course.back() / gap_)),
              PenalisedSpline::penaltyFor(wavelength, gap_)) {
    const std::vector<double> progress = evenCourse(course, 0.5 * wavelength);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double length = i == 0 ? 0.0 : course[i] - course[i - 1];
        const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(2.0 * length / gap_)));
        const double piece = i == 0 ? 0.0 : (progress[i] - progress[i - 1]) / static_cast<double>(pieces);
        if (i > 0) weights_.back() += 0.5 * piece;
        for (std::size_t k = 1; i > 0 && k < pieces; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(pieces);
            add(course[i - 1] + share * length, glm::mix(points[i - 1].pose.tip, points[i].pose.tip, share), piece);
        }
        pointAt_.push_back(at_.size());
        add(course[i], points[i].pose.tip, 0.5 * piece);
    }
}

glm::dvec3 ShapeFit::direction(std::size_t point) const noexcept {
    const glm::dvec3 slope = spline_.direction(at_[pointAt_[point]].cell, shares_[pointAt_[point]]);
    const double length = glm::length(slope);
    return length > 0.0 ? slope / length : glm::dvec3(0.0);
}

void ShapeFit::weigh(std::size_t point, double times) noexcept {
    double& weight = weights_[pointAt_[point]];
    weight = std::min(mostWeight, std::max(weight, leastWeight) * times);
}

void ShapeFit::pin(std::size_t point) noexcept {
    weights_[pointAt_[point]] = mostWeight;
}

void ShapeFit::add(double course, const glm::dvec3& tip, double weight) {
    const double cells = course / gap_;
    const auto cell = static_cast<std::size_t>(cells);
    shares_.push_back(cells - static_cast<double>(cell));
    at_.push_back(splinePosition(cell, shares_.back()));
    tips_.push_back(tip);
    weights_.push_back(weight);
}

/// Lengths along a curve that was fitted with a first, coarse course.
std::vector<double> courseAlong(const ShapeFit& fit, std::span<const StrokePoint> points) {
    std::vector<double> course(points.size(), 0.0);
    double length = 0.0;
    glm::dvec3 last = fit.tip(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 curve = fit.tip(i);
        length += glm::distance(last, curve);
        course[i] = length + glm::dot(points[i].pose.tip - curve, fit.direction(i));
        last = curve;
    }
    makeMonotone(course);
    const double begin = course.front();
    for (double& at : course) at -= begin;
    return course;
}

} // namespace burin
