// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/path/apply.h"
#include "core/path/penalised_spline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

/// Knots in a period of the cut-off: dense enough to follow corners where the tube requires it.
constexpr double knotsPerPeriod = 40.0;
/// How often the weight of points outside the tube is increased. Points that are still outside are put onto its wall.
constexpr int rounds = 16;
/// Target, as a share of the tolerance.
constexpr double aim = 0.97;
constexpr double heaviest = 1e7;

/// A spline in time through a stroke's evenly timed points.
class TimedSpline {
public:
    TimedSpline(const PathStroke& stroke, double cutOff) : weights(stroke.points.size(), 1.0) {
        const auto perKnot =
            std::max<std::size_t>(1, static_cast<std::size_t>(1.0 / (knotsPerPeriod * cutOff * stroke.tickPeriod)));
        for (std::size_t k = 0; k < stroke.points.size(); ++k) {
            at_.push_back(splinePosition(k / perKnot, static_cast<double>(k % perKnot) / static_cast<double>(perKnot)));
            tips_.push_back(stroke.points[k].pose.tip);
        }
        const double gap = static_cast<double>(perKnot) * stroke.tickPeriod;
        const double penalty = std::pow(2.0 * pi * cutOff, -6.0) * std::pow(gap, -5.0) / stroke.tickPeriod;
        spline_.emplace(PenalisedSpline::sizeFor((stroke.points.size() - 1) / perKnot), penalty);
    }

    /// The spline at each point's time.
    std::vector<glm::dvec3> fitted() {
        spline_->fit(at_, tips_, weights);
        std::vector<glm::dvec3> tips;
        tips.reserve(at_.size());
        for (const SplinePosition& at : at_) tips.push_back(spline_->at(at));
        return tips;
    }

    std::vector<double> weights; ///< of the points

private:
    std::vector<SplinePosition> at_;
    std::vector<glm::dvec3> tips_;
    std::optional<PenalisedSpline> spline_;
};

/// Both polylines have a corner at each tick, so that the distance of the ticks bounds the distance of any two points.
Deviation smooth(PathStroke& stroke, const SmoothSpline& edit, const Progress& progress) {
    Deviation deviation;
    std::vector<StrokePoint>& points = stroke.points;
    if (points.size() < 4 || !stroke.inTime()) return deviation;
    TimedSpline spline(stroke, edit.cutOff);
    std::vector<glm::dvec3> tips;
    for (int round = 0; round <= rounds && !progress.cancelled(); ++round) {
        tips = spline.fitted();
        bool within = true;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double off = glm::distance(tips[k], points[k].pose.tip);
            if (off <= edit.tolerance) continue;
            within = false;
            const double times = edit.tolerance > 0.0 ? off / (aim * edit.tolerance) : heaviest;
            spline.weights[k] = std::min(heaviest, spline.weights[k] * times * times);
        }
        if (within) break;
    }
    if (progress.cancelled()) return deviation;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const glm::dvec3 shift = clampLength(tips[k] - points[k].pose.tip, edit.tolerance);
        points[k].pose.tip += shift;
        deviation.include(glm::length(shift), points[k].pose.tip);
    }
    return deviation;
}

} // namespace

Result<Deviation> apply(const SmoothSpline& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    if (Result<void> usable = checkCutOff(edit.cutOff, state); !usable) return usable.error();
    return changeEach(state, progress, [&](PathStroke& stroke) { return smooth(stroke, edit, progress); });
}

} // namespace burin
