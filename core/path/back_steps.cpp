// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/back_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace burin {
namespace {

/// Extent of the window on either side of a back-step: largest distance and largest number of points.
constexpr double reach = 3.0 * longestBackStep; // mm
constexpr std::size_t mostPoints = 24;

/// The distance by which a move leaves a polyline, mm; never understated. Exact where both ends are nearest to the same
/// segment, else halved until the error hardly counts. Stops early beyond `limit`.
double farthestOf(const glm::dvec3& from, const glm::dvec3& to, std::span<const glm::dvec3> line, double limit,
                  int halvings = 6) {
    double least = std::numeric_limits<double>::infinity(), nearFrom = least, nearTo = least;
    for (std::size_t k = 1; k < line.size(); ++k) {
        const double first = distanceToSegment(from, line[k - 1], line[k]);
        const double second = distanceToSegment(to, line[k - 1], line[k]);
        least = std::min(least, std::max(first, second)); // distance from a segment is convex
        nearFrom = std::min(nearFrom, first);
        nearTo = std::min(nearTo, second);
    }
    const double ends = std::max(nearFrom, nearTo);
    if (least <= ends || halvings == 0 || ends > limit) return least;
    const glm::dvec3 middle = 0.5 * (from + to);
    return std::max(farthestOf(from, middle, line, limit, halvings - 1),
                    farthestOf(middle, to, line, limit, halvings - 1));
}

class BackStepDropper {
public:
    BackStepDropper(std::span<const StrokePoint> points, double tolerance, const ShortcutTest& allowed)
        : points_(points), tolerance_(tolerance), allowed_(allowed) {}

    /// @return the remaining indices
    std::vector<std::size_t> dropFrom(const std::vector<std::size_t>& kept, const Progress& progress) {
        // Pending points are in reverse order, so that taking one, or putting some back for another check, moves no
        // others.
        std::vector<std::size_t> waiting(kept.rbegin(), kept.rend()), done;
        while (!waiting.empty() && !progress.cancelled()) {
            done.push_back(waiting.back());
            waiting.pop_back();
            if (done.size() < 3 || !stepsBack(done[done.size() - 3], done[done.size() - 2], done.back())) continue;
            const std::size_t turn = done[done.size() - 2];
            const std::size_t before = 1 + countNear(turn, done.rbegin() + 1, done.rend()); // with the point behind it
            const std::size_t behind = countNear(turn, waiting.rbegin(), waiting.rend());
            std::vector<std::size_t> window(done.end() - static_cast<std::ptrdiff_t>(before), done.end());
            window.insert(window.end(), waiting.rbegin(), waiting.rbegin() + static_cast<std::ptrdiff_t>(behind));
            if (!shorten(window)) continue;
            done.resize(done.size() - before);
            waiting.resize(waiting.size() - behind);
            waiting.insert(waiting.end(), window.rbegin(), window.rend());
        }
        done.insert(done.end(), waiting.rbegin(), waiting.rend());
        return done;
    }
    const Deviation& farthest() const noexcept { return farthest_; }

private:
    bool stepsBack(std::size_t from, std::size_t at, std::size_t to) const {
        return !points_[at].arc && !points_[to].arc &&
               isBackStep(points_[from].pose.tip, points_[at].pose.tip, points_[to].pose.tip);
    }

    /// The number of points in the window, and one beyond: a move that comes from outside counts as well.
    template <class Iterator>
    std::size_t countNear(std::size_t turn, Iterator at, Iterator end) const {
        std::size_t count = 0;
        for (; at != end && count < mostPoints; ++at) {
            ++count;
            if (glm::distance(points_[*at].pose.tip, points_[turn].pose.tip) > reach) break;
        }
        return count;
    }

    /// Replaces several moves by one straight move: the one that leaves the fewest back-steps.
    /// @return false if none is near enough to the moves that it replaces, or none is allowed
    bool shorten(std::vector<std::size_t>& window) {
        const std::size_t size = window.size();
        std::vector<std::size_t> turnsBefore(size + 1, 0); // back-steps at points with a lower index
        for (std::size_t i = 0; i < size; ++i)
            turnsBefore[i + 1] =
                turnsBefore[i] +
                (i > 0 && i + 1 < size && stepsBack(window[i - 1], window[i], window[i + 1]) ? 1U : 0U);
        std::size_t fewest = turnsBefore[size], from = 0, to = 0;
        Deviation least;
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = i + 2; j < size && !points_[window[j - 1]].arc && !points_[window[j]].arc; ++j) {
                std::size_t left = turnsBefore[i] + turnsBefore[size] - turnsBefore[j + 1];
                if (i > 0 && stepsBack(window[i - 1], window[i], window[j])) ++left;
                if (j + 1 < size && stepsBack(window[i], window[j], window[j + 1])) ++left;
                if (left >= turnsBefore[size] || left > fewest) continue;
                const Deviation deviation = deviationOf(window, i, j);
                const bool better = to == 0 || left < fewest || deviation.distance < least.distance;
                if (!better || deviation.distance > tolerance_) continue;
                if (!allowed_(points_[window[i]].pose.tip, points_[window[j]].pose.tip)) continue;
                fewest = left;
                least = deviation;
                from = i;
                to = j;
            }
        if (to == 0) return false;
        window.erase(window.begin() + static_cast<std::ptrdiff_t>(from + 1),
                     window.begin() + static_cast<std::ptrdiff_t>(to));
        farthest_.include(least);
        return true;
    }

    /// The distance between the path and its replacement if one move replaces those between two points of a window. The
    /// moves on either side are compared as well: points that were left out of them may rely on points that are removed
    /// now.
    Deviation deviationOf(const std::vector<std::size_t>& window, std::size_t from, std::size_t to) const {
        const std::size_t first = from - std::min<std::size_t>(from, 1), last = std::min(to + 1, window.size() - 1);
        std::vector<glm::dvec3> before, after;
        for (std::size_t k = window[first]; k <= window[last]; ++k) before.push_back(points_[k].pose.tip);
        for (std::size_t i = from - std::min<std::size_t>(from, 2); i <= std::min(to + 2, window.size() - 1); ++i)
            if (i <= from || i >= to) after.push_back(points_[window[i]].pose.tip);
        Deviation deviation;
        for (std::size_t k = 1; k < before.size() && deviation.distance <= tolerance_; ++k)
            deviation.include(farthestOf(before[k - 1], before[k], after, tolerance_), before[k]);
        deviation.include(farthestOf(points_[window[from]].pose.tip, points_[window[to]].pose.tip, before, tolerance_),
                          points_[window[to]].pose.tip);
        return deviation;
    }

    std::span<const StrokePoint> points_;
    double tolerance_; // mm
    const ShortcutTest& allowed_;
    Deviation farthest_;
};

} // namespace

bool isBackStep(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& to) noexcept {
    const glm::dvec3 in = at - from, out = to - at;
    const double lengths = glm::length(in) * glm::length(out);
    return lengths > 0.0 && glm::dot(in, out) < std::cos(backStepTurn) * lengths &&
           std::min(glm::length(in), glm::length(out)) < longestBackStep;
}

Deviation dropBackSteps(std::span<const StrokePoint> points, std::vector<std::size_t>& kept, double tolerance,
                        const ShortcutTest& allowed, const Progress& progress) {
    BackStepDropper dropper(points, tolerance, allowed);
    kept = dropper.dropFrom(kept, progress);
    return dropper.farthest();
}

Deviation dropBackSteps(PathUnderEdit& state, const PartGuard& guard, const Progress& progress) {
    return changeEach(state, progress, [&](PathStroke& stroke) {
        std::vector<std::size_t> kept(stroke.points.size());
        std::iota(kept.begin(), kept.end(), std::size_t{0});
        const auto staysClear = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return guard.isClear(from, to, stroke.required, defaultSampling);
        };
        const Deviation deviation = dropBackSteps(stroke.points, kept, backStepTolerance, staysClear, progress);
        keepOnly(stroke.points, kept);
        return deviation;
    });
}

} // namespace burin
