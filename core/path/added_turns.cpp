// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/added_turns.h"

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/geometry/angle.h"
#include "core/path/back_steps.h"
#include "core/path/polyline.h"
#include "core/path/sliding_window.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin {
namespace {

/// Difference between two versions of one bend that is tolerated, as their chords begin at different points.
constexpr double turnSlack = 6.0 * pi / 180.0; // rad
/// The recorded stroke is evaluated over a window enlarged by this share on either side, as a bend may be slightly
/// shifted.
constexpr double marginShare = 0.25;
constexpr int mostRounds = 12;
constexpr std::size_t markedTogether = 4096; // points that justify another core

/// The sum over all points of a window. @param sums up to each point
template <class Sum>
Sum sumWithin(const std::vector<Sum>& sums, const SlidingWindow& window) {
    const Sum all = sums[window.end() - 1];
    return window.first() == 0 ? all : all - sums[window.first() - 1];
}

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
void countMovesThatStepBack(std::span<const glm::dvec3> tips, std::vector<std::size_t>& backSteps) {
    constexpr double standing = 1e-6; // mm
    std::vector<std::size_t> apart;
    for (std::size_t i = 0; i < tips.size(); ++i)
        if (apart.empty() || glm::distance(tips[i], tips[apart.back()]) > standing) apart.push_back(i);
    for (std::size_t k = 1; k + 1 < apart.size(); ++k)
        if (isBackStep(tips[apart[k - 1]], tips[apart[k]], tips[apart[k + 1]])) ++backSteps[apart[k]];
}

} // namespace

TurnCount::TurnCount(std::span<const glm::dvec3> tips, double detail, const Progress& progress)
    : turns(tips.size(), 0.0), backSteps(tips.size(), 0) {
    const std::vector<std::size_t> kept = simplifyInGroups(tips, detail, progress);
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
        const glm::dvec3 &from = tips[kept[k - 1]], &at = tips[kept[k]], &to = tips[kept[k + 1]];
        turns[kept[k]] = angleBetween(at - from, to - at);
        backSteps[kept[k]] = isBackStep(from, at, to) ? 1 : 0;
    }
    countMovesThatStepBack(tips, backSteps);
    for (std::size_t i = 1; i < tips.size(); ++i) {
        turns[i] += turns[i - 1];
        backSteps[i] += backSteps[i - 1];
    }
}

AddedTurns::AddedTurns(std::span<const glm::dvec3> recorded, std::span<const double> course, const TurnLimits& limits,
                       const Progress& progress)
    : recorded_(recorded), course_(course), limits_(limits), before_(recorded, limits.detail, progress) {}

std::vector<bool> AddedTurns::in(std::span<const glm::dvec3> smoothed, const Progress& progress) const {
    const TurnCount after(smoothed, limits_.detail, progress);
    const double half = 0.5 * limits_.window, margin = marginShare * limits_.window;
    std::vector<std::uint8_t> marked(smoothed.size(), 0); // bytes, which threads may write beside each other
    parallelIntervals(std::size_t{0}, marked.size(), markedTogether, [&](std::size_t from, std::size_t end) {
        SlidingWindow window(course_, half), wider(course_, half + margin);
        for (std::size_t i = from; i != end; ++i) {
            window.moveTo(i);
            wider.moveTo(i);
            marked[i] = sumWithin(after.turns, window) > sumWithin(before_.turns, wider) + turnSlack ||
                        sumWithin(after.backSteps, window) > sumWithin(before_.backSteps, wider);
        }
    });
    return {marked.begin(), marked.end()};
}

void AddedTurns::undo(std::vector<glm::dvec3>& smoothed, const Progress& progress) const {
    const std::vector<glm::dvec3> wanted = smoothed;
    Shares shares(course_, limits_.window);
    for (int round = 0; !progress.cancelled(); ++round) {
        for (std::size_t i = 0; i < smoothed.size(); ++i) smoothed[i] = glm::mix(recorded_[i], wanted[i], shares[i]);
        std::vector<bool> marked = in(smoothed, progress);
        if (round == mostRounds) marked.assign(marked.size(), true); // rather no smoothing than a bad one
        if (!shares.takeFrom(marked, 0.5 * limits_.window)) return;
    }
}

} // namespace burin
