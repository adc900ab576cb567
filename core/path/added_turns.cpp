// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/added_turns.h"

#include "core/base/units.h"
#include "core/geometry/angle.h"
#include "core/path/back_steps.h"
#include "core/path/polyline.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Difference between two versions of one bend that is tolerated, as their chords begin at different points.
constexpr double turnSlack = 6.0 * pi / 180.0; // rad
/// The recorded stroke is evaluated over a window enlarged by this share on either side, as a bend may be slightly
/// shifted.
constexpr double marginShare = 0.25;
constexpr int mostRounds = 12;

/// Intervals of a stroke, by its course.
class Intervals {
public:
    explicit Intervals(std::span<const double> course) : course_(course) {}

    /// The sum over all points within `half` mm of a point.
    template <class Sum>
    Sum within(const std::vector<Sum>& sums, std::size_t point, double half) const {
        const auto [first, last] = around(point, half);
        return first == 0 ? sums[last] : sums[last] - sums[first - 1];
    }
    /// First and last point within `half` mm of a point.
    std::pair<std::size_t, std::size_t> around(std::size_t point, double half) const {
        const auto first = std::lower_bound(course_.begin(), course_.end(), course_[point] - half);
        const auto last = std::upper_bound(course_.begin(), course_.end(), course_[point] + half);
        return {static_cast<std::size_t>(first - course_.begin()),
                static_cast<std::size_t>(last - course_.begin()) - 1};
    }

private:
    std::span<const double> course_; // mm
};

/// Share of the smoothing that is kept at each point.
class Shares {
public:
    Shares(std::span<const double> course, double ramp) : course_(course), ramp_(ramp), shares_(course.size(), 1.0) {}

    /// Reduces the share to zero within `reach` of each marked point, rising to one over the next `ramp_`.
    /// @param marked one per point @return whether anything changed
    bool takeFrom(const std::vector<bool>& marked, double reach) {
        bool changed = false;
        double last = -1e300; // course at the last marked point
        const auto lower = [&](std::size_t i, double distance) {
            const double share = glm::smoothstep(reach, reach + ramp_, distance);
            if (share >= shares_[i]) return;
            shares_[i] = share;
            changed = true;
        };
        for (std::size_t i = 0; i < shares_.size(); ++i) {
            if (marked[i]) last = course_[i];
            lower(i, course_[i] - last);
        }
        last = 1e300;
        for (std::size_t i = shares_.size(); i-- > 0;) {
            if (marked[i]) last = course_[i];
            lower(i, last - course_[i]);
        }
        return changed;
    }
    double operator[](std::size_t point) const noexcept { return shares_[point]; }

private:
    std::span<const double> course_; // mm
    double ramp_;                    // mm
    std::vector<double> shares_;
};

} // namespace

namespace {

/// Counts single points as well: where two curves meet in a corner nearly as acute as a back-step.
void countMovesThatStepBack(std::span<const StrokePoint> points, std::vector<std::size_t>& backSteps) {
    constexpr double standing = 1e-6; // mm
    std::vector<std::size_t> apart;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (apart.empty() || glm::distance(points[i].pose.tip, points[apart.back()].pose.tip) > standing)
            apart.push_back(i);
    for (std::size_t k = 1; k + 1 < apart.size(); ++k)
        if (isBackStep(points[apart[k - 1]].pose.tip, points[apart[k]].pose.tip, points[apart[k + 1]].pose.tip))
            ++backSteps[apart[k]];
}

} // namespace

TurnCount::TurnCount(std::span<const StrokePoint> points, double detail, const Progress& progress)
    : turns(points.size(), 0.0), backSteps(points.size(), 0) {
    const auto anywhere = [](const glm::dvec3&, const glm::dvec3&) { return true; };
    const std::vector<std::size_t> kept = simplifyInGroups(points, detail, anywhere, progress);
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
        const glm::dvec3 &from = points[kept[k - 1]].pose.tip, &at = points[kept[k]].pose.tip,
                         &to = points[kept[k + 1]].pose.tip;
        turns[kept[k]] = angleBetween(at - from, to - at);
        backSteps[kept[k]] = isBackStep(from, at, to) ? 1 : 0;
    }
    countMovesThatStepBack(points, backSteps);
    for (std::size_t i = 1; i < points.size(); ++i) {
        turns[i] += turns[i - 1];
        backSteps[i] += backSteps[i - 1];
    }
}

AddedTurns::AddedTurns(std::span<const StrokePoint> recorded, std::span<const double> course, const TurnLimits& limits,
                       const Progress& progress)
    : recorded_(recorded), course_(course), limits_(limits), before_(recorded, limits.detail, progress) {}

std::vector<bool> AddedTurns::in(std::span<const glm::dvec3> smoothed, const Progress& progress) const {
    std::vector<StrokePoint> points(recorded_.begin(), recorded_.end());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].pose.tip = smoothed[i];
    const TurnCount after(points, limits_.detail, progress);
    const Intervals intervals(course_);
    const double half = 0.5 * limits_.window, margin = marginShare * limits_.window;
    std::vector<bool> marked(points.size(), false);
    for (std::size_t i = 0; i < marked.size(); ++i)
        marked[i] =
            intervals.within(after.turns, i, half) > intervals.within(before_.turns, i, half + margin) + turnSlack ||
            intervals.within(after.backSteps, i, half) > intervals.within(before_.backSteps, i, half + margin);
    return marked;
}

void AddedTurns::undo(std::vector<glm::dvec3>& smoothed, const Progress& progress) const {
    const std::vector<glm::dvec3> wanted = smoothed;
    Shares shares(course_, limits_.window);
    for (int round = 0; !progress.cancelled(); ++round) {
        for (std::size_t i = 0; i < smoothed.size(); ++i)
            smoothed[i] = glm::mix(recorded_[i].pose.tip, wanted[i], shares[i]);
        std::vector<bool> marked = in(smoothed, progress);
        if (round == mostRounds) marked.assign(marked.size(), true); // rather no smoothing than a bad one
        if (!shares.takeFrom(marked, 0.5 * limits_.window)) return;
    }
}

} // namespace burin
