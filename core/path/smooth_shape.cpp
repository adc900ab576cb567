// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/added_turns.h"
#include "core/path/apply.h"
#include "core/path/curve_deviation.h"
#include "core/path/penalised_spline.h"
#include "core/path/shape_course.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Gaps between knots: so many in a wavelength of the cut-off, or so many tolerances long.
constexpr double knotsInWavelength = 40.0, knotsInTolerance = 4.0;
/// Steps back of less than this share of the wavelength, and chords that the shape bends away from by less than the
/// other one, say nothing of the shape.
constexpr double slackShare = 0.5, chordShare = 0.1;
/// So often points outside of the tube get more weight.
constexpr int tubeRounds = 16;
constexpr double tubeAim = 0.97; // share of the tolerance
/// Bends that stay within this share of the tolerance are none.
constexpr double bendShare = 0.1;
/// Weights, mm of the course: what a point that leaves the tube counts at least, and at most.
constexpr double leastWeight = 1e-3, mostWeight = 1e6;

/// A curve by its own length, fitted to a stroke's points and to the moves between them. They count by the progress of
/// the course without tremor: a hand that rests says hardly more about the shape than one that passes, and within a
/// wave of tremor all points count alike. By their own length those would count more where tremor hurries the hand on,
/// and the mean of a wave would not be its middle.
class ShapeFit {
public:
    /// @param course mm, of each point @param wavelength cut-off, mm @param gap between knots, mm
    ShapeFit(std::span<const StrokePoint> points, std::span<const double> course, double wavelength, double gap)
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
                add(course[i - 1] + share * length, glm::mix(points[i - 1].tip, points[i].tip, share), piece);
            }
            pointAt_.push_back(at_.size());
            add(course[i], points[i].tip, 0.5 * piece);
        }
    }

    void fit() { spline_.fit(at_, tips_, weights_); }
    /// The curve at a point's length.
    glm::dvec3 tip(std::size_t point) const noexcept { return spline_(at_[pointAt_[point]]); }
    /// Unit; zero where the curve stands.
    glm::dvec3 direction(std::size_t point) const noexcept {
        const glm::dvec3 slope = spline_.direction(at_[pointAt_[point]].cell, shares_[pointAt_[point]]);
        const double length = glm::length(slope);
        return length > 0.0 ? slope / length : glm::dvec3(0.0);
    }
    void weigh(std::size_t point, double times) noexcept {
        double& weight = weights_[pointAt_[point]];
        weight = std::min(mostWeight, std::max(weight, leastWeight) * times);
    }

private:
    void add(double course, const glm::dvec3& tip, double weight) {
        const double cells = course / gap_;
        const auto cell = static_cast<std::size_t>(cells);
        shares_.push_back(cells - static_cast<double>(cell));
        at_.push_back(splinePosition(cell, shares_.back()));
        tips_.push_back(tip);
        weights_.push_back(weight);
    }

    double gap_; // mm
    PenalisedSpline spline_;
    std::vector<SplinePosition> at_; // of the points and of what stands between them
    std::vector<double> shares_, weights_;
    std::vector<glm::dvec3> tips_;
    std::vector<std::size_t> pointAt_;
};

/// Lengths along the curve that a first, coarse course led to.
std::vector<double> courseAlong(const ShapeFit& fit, std::span<const StrokePoint> points) {
    std::vector<double> course(points.size(), 0.0);
    double length = 0.0;
    glm::dvec3 last = fit.tip(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 curve = fit.tip(i);
        length += glm::distance(last, curve);
        course[i] = length + glm::dot(points[i].tip - curve, fit.direction(i));
        last = curve;
    }
    makeMonotone(course);
    const double begin = course.front();
    for (double& at : course) at -= begin;
    return course;
}

/// A stroke and the tube around it: both the recorded points and the curve's stay in it. Along the curve the law of
/// time may differ; that is no deviation.
class Tube {
public:
    Tube(std::vector<glm::dvec3> tips, double tolerance, double reach)
        : tips_(std::move(tips)), curve_(tips_, reach), tolerance_(tolerance), reach_(reach) {}

    /// How far each point is from the other curve, mm; what is within the tolerance may be anything up to it.
    std::vector<double> offsets(std::span<const glm::dvec3> smoothed) const {
        const StrokeCurve other(smoothed, reach_);
        std::vector<double> offsets(tips_.size(), 0.0);
        for (std::size_t i = 0; i < tips_.size(); ++i)
            if (glm::distance(tips_[i], smoothed[i]) > tolerance_)
                offsets[i] =
                    std::max(other.distance(tips_[i], i, tolerance_), curve_.distance(smoothed[i], i, tolerance_));
        return offsets;
    }

    /// What could not be drawn into the tube stays as it was recorded.
    void restoreOutside(std::vector<glm::dvec3>& smoothed, const Progress& progress) const {
        for (std::size_t around = 0; !progress.cancelled(); around = 2 * around + 1) {
            const std::vector<double> off = offsets(smoothed);
            bool within = true;
            for (std::size_t i = 0; i < off.size(); ++i) {
                if (off[i] <= tolerance_) continue;
                within = false;
                const std::size_t first = i - std::min(i, around), last = std::min(i + around, off.size() - 1);
                for (std::size_t k = first; k <= last; ++k) smoothed[k] = tips_[k];
            }
            if (within) return;
        }
    }

    double tolerance() const noexcept { return tolerance_; }

private:
    std::vector<glm::dvec3> tips_; // recorded, mm
    StrokeCurve curve_;
    double tolerance_, reach_; // mm; along the curve
};

/// The curve at each point, drawn into the tube by giving weight to points that are outside of it.
std::vector<glm::dvec3> fitInTube(ShapeFit& fit, const Tube& tube, std::size_t count, const Progress& progress) {
    std::vector<glm::dvec3> smoothed(count);
    for (int round = 0; round <= tubeRounds && !progress.cancelled(); ++round) {
        fit.fit();
        for (std::size_t i = 0; i < count; ++i) smoothed[i] = fit.tip(i);
        const std::vector<double> off = tube.offsets(smoothed);
        bool within = true;
        for (std::size_t i = 0; i < count; ++i) {
            if (off[i] <= tube.tolerance()) continue;
            within = false;
            const double times = off[i] / (tubeAim * tube.tolerance());
            fit.weigh(i, times * times);
        }
        if (within) break;
    }
    return smoothed;
}

Deviation smooth(PathStroke& stroke, const SmoothShape& edit, const Progress& progress) {
    std::vector<StrokePoint>& points = stroke.points;
    // Knots are dense enough to go round corners where the tube demands it.
    const double gap = std::min(edit.wavelength / knotsInWavelength, knotsInTolerance * edit.tolerance);
    const double shortest = 4.0 * gap; // mm: less says nothing of a shape
    std::vector<double> course =
        shapeCourse(points, chordShare * edit.wavelength, slackShare * edit.wavelength, progress);
    if (progress.cancelled() || edit.tolerance <= 0.0 || course.empty() || course.back() < shortest) return {};
    ShapeFit coarse(points, course, edit.wavelength, gap);
    coarse.fit();
    course = courseAlong(coarse, points);
    if (course.back() < shortest) return {};
    std::vector<glm::dvec3> recorded;
    for (const StrokePoint& point : points) recorded.push_back(point.tip);
    ShapeFit fit(points, course, edit.wavelength, gap);
    const double reach = edit.wavelength; // steps back of less than half of it go
    const Tube tube(recorded, edit.tolerance, reach);
    std::vector<glm::dvec3> smoothed = fitInTube(fit, tube, points.size(), progress);
    tube.restoreOutside(smoothed, progress);
    undoAddedTurns(points, course, {edit.wavelength, bendShare * edit.tolerance}, smoothed, progress);
    tube.restoreOutside(smoothed, progress);
    if (progress.cancelled()) return {};
    for (std::size_t i = 0; i < points.size(); ++i) points[i].tip = smoothed[i];
    return curveDeviation(recorded, smoothed, reach);
}

} // namespace

Result<Deviation> apply(const SmoothShape& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    return changeEach(state, progress, [&](PathStroke& stroke) { return smooth(stroke, edit, progress); });
}

} // namespace burin
