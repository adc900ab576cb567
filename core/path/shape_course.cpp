// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/shape_course.h"

#include "core/base/parallel.h"
#include "core/path/polyline.h"
#include "core/path/sliding_window.h"

#include <algorithm>
#include <cstddef>

namespace burin {
namespace {

constexpr std::size_t evenedTogether = 4096; // points that justify another core

/// Projections of points of a stroke onto its chord, mm from the first point, each between 0 and the chord's length.
std::vector<double> alongChord(std::span<const StrokePoint> points) {
    const glm::dvec3 from = points.front().pose.tip, chord = points.back().pose.tip - from;
    const double length = glm::length(chord);
    std::vector<double> along;
    along.reserve(points.size());
    for (const StrokePoint& point : points)
        along.push_back(length > 0.0 ? std::clamp(glm::dot(point.pose.tip - from, chord) / length, 0.0, length) : 0.0);
    return along;
}

/// The longest step back: where it begins and ends.
struct StepBack {
    std::size_t from = 0, to = 0;
    double length = 0.0; ///< mm
};
StepBack longestStepBack(std::span<const double> along) {
    StepBack longest;
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < along.size(); ++i) {
        if (along[i] > along[farthest]) farthest = i;
        const double back = along[farthest] - along[i];
        if (back > longest.length) longest = {farthest, i, back};
    }
    return longest;
}

} // namespace

void makeMonotone(std::span<double> values) {
    struct Pool {
        double sum;
        std::size_t count;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Pool> pools;
    for (const double value : values) {
        pools.push_back({value, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean()) {
            pools[pools.size() - 2].sum += pools.back().sum;
            pools[pools.size() - 2].count += pools.back().count;
            pools.pop_back();
        }
    }
    std::size_t i = 0;
    for (const Pool& pool : pools)
        for (std::size_t k = 0; k < pool.count; ++k) values[i++] = pool.mean();
}

std::vector<double> evenCourse(std::span<const double> course, double reach) {
    std::vector<double> sums(course.size() + 1, 0.0), even(course.size(), 0.0);
    for (std::size_t i = 0; i < course.size(); ++i) sums[i + 1] = sums[i] + course[i];
    parallelIntervals(std::size_t{0}, course.size(), evenedTogether, [&](std::size_t from, std::size_t end) {
        SlidingWindow window(course, reach);
        for (std::size_t i = from; i != end; ++i) {
            window.moveTo(i);
            const std::size_t around = std::min(i - window.first(), window.end() - 1 - i);
            even[i] = (sums[i + around + 1] - sums[i - around]) / static_cast<double>(2 * around + 1);
        }
    });
    makeMonotone(even);
    return even;
}

std::vector<double> shapeCourse(std::span<const StrokePoint> points, double chord, double slack,
                                const Progress& progress) {
    std::vector<double> course(points.size(), 0.0);
    if (points.size() < 2) return course;
    const std::vector<std::size_t> corners = simplifyInGroups(
        points, chord, [](const glm::dvec3&, const glm::dvec3&) { return true; }, progress);
    // A chord along which the hand turned back is split in three; the nearest of the pending ones is last.
    std::vector<std::size_t> ends(corners.rbegin(), corners.rend());
    ends.pop_back();
    std::size_t first = 0;
    double length = 0.0;
    while (!ends.empty() && !progress.cancelled()) {
        const std::size_t last = ends.back();
        std::vector<double> along = alongChord(points.subspan(first, last - first + 1));
        if (const StepBack back = longestStepBack(along); back.length > slack) {
            ends.push_back(first + back.to);
            ends.push_back(first + back.from);
            continue;
        }
        makeMonotone(along);
        for (std::size_t i = 0; i < along.size(); ++i) course[first + i] = length + along[i];
        length += along.back();
        first = last;
        ends.pop_back();
    }
    return course;
}

} // namespace burin
