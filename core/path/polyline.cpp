// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/polyline.h"
#include "core/base/parallel.h"

#include <algorithm>

namespace burin {

namespace {

const glm::dvec3& lineTip(const StrokePoint& point) noexcept {
    return point.pose.tip;
}
const glm::dvec3& lineTip(const glm::dvec3& tip) noexcept {
    return tip;
}

template <class Point, class Test>
std::vector<std::size_t> simplifyLine(std::span<const Point> points, double tolerance, const Test& allowed) {
    std::vector<std::size_t> kept;
    if (points.empty()) return kept;
    kept.push_back(0);
    std::vector<std::size_t> ends; // of the pending ranges, nearest last
    if (points.size() > 1) ends.push_back(points.size() - 1);
    while (!ends.empty()) {
        const std::size_t first = kept.back(), last = ends.back();
        const glm::dvec3 &from = lineTip(points[first]), &to = lineTip(points[last]);
        std::size_t farthest = first + (last - first) / 2; // where a forbidden shortcut between equal points is split
        double distance = 0.0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distanceToSegment(lineTip(points[i]), from, to);
            if (d > distance) {
                distance = d;
                farthest = i;
            }
        }
        if (last == first + 1 || (distance <= tolerance && allowed(from, to))) {
            kept.push_back(last);
            ends.pop_back();
        } else {
            ends.push_back(farthest);
        }
    }
    return kept;
}

template <class Point, class Test>
std::vector<std::size_t> simplifyGroups(std::span<const Point> points, double tolerance, const Test& allowed,
                                        const Progress& progress) {
    const std::size_t groups = points.size() < 2 ? 1 : (points.size() - 2) / simplifyGroup + 1;
    std::vector<std::vector<std::size_t>> parts(groups);
    parallelFor(std::size_t{0}, groups, [&](std::size_t group) {
        if (progress.cancelled()) return;
        const std::size_t first = group * simplifyGroup;
        const std::size_t count = std::min(simplifyGroup + 1, points.size() - first); // ends are shared
        parts[group] = simplifyLine(points.subspan(first, count), tolerance, allowed);
        for (std::size_t& index : parts[group]) index += first;
    });
    std::vector<std::size_t> kept;
    for (const std::vector<std::size_t>& part : parts) {
        const bool shared = !kept.empty() && !part.empty() && part.front() == kept.back();
        kept.insert(kept.end(), part.begin() + (shared ? 1 : 0), part.end());
    }
    return kept;
}

} // namespace

std::vector<std::size_t> simplify(std::span<const StrokePoint> points, double tolerance, const ShortcutTest& allowed) {
    return simplifyLine(points, tolerance, allowed);
}

std::vector<std::size_t> simplifyInGroups(std::span<const StrokePoint> points, double tolerance,
                                          const ShortcutTest& allowed, const Progress& progress) {
    return simplifyGroups(points, tolerance, allowed, progress);
}

std::vector<std::size_t> simplifyInGroups(std::span<const glm::dvec3> tips, double tolerance,
                                          const Progress& progress) {
    return simplifyGroups(
        tips, tolerance, [](const glm::dvec3&, const glm::dvec3&) { return true; }, progress);
}

Deviation thinnedDeviation(std::span<const StrokePoint> points, std::span<const std::size_t> kept) {
    Deviation deviation;
    for (std::size_t k = 1; k < kept.size(); ++k) {
        for (std::size_t i = kept[k - 1] + 1; i < kept[k]; ++i)
            deviation.include(
                distanceToSegment(points[i].pose.tip, points[kept[k - 1]].pose.tip, points[kept[k]].pose.tip),
                points[i].pose.tip);
    }
    return deviation;
}

void keepOnly(std::vector<StrokePoint>& points, std::span<const std::size_t> kept) {
    std::size_t from = 0, to = 0;
    for (const std::size_t index : kept) {
        StrokePoint point = points[index];
        for (; from < index; ++from) {
            point.removes = point.removes || points[from].removes;
            point.onBoundary = point.onBoundary || points[from].onBoundary;
        }
        from = index + 1;
        points[to++] = point;
    }
    points.resize(to);
}

} // namespace burin
