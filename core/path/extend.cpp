// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double direction = 1.0;     // mm of a stroke that determine its direction: less would follow tremor
constexpr double farthestApart = 0.2; // mm between new points

/// Adds this length before the start.
void extendStart(std::vector<StrokePoint>& points, double length) {
    if (!(length > 0.0) || points.size() < 2) return;
    const StrokePoint start = points.front();
    std::size_t inner = 1;
    while (inner + 1 < points.size() && glm::distance(points[inner].pose.tip, start.pose.tip) < direction) ++inner;
    const glm::dvec3 way = start.pose.tip - points[inner].pose.tip;
    if (!(glm::length(way) > 0.0)) return;
    const double beside = glm::distance(points[1].pose.tip, start.pose.tip);
    const auto count = static_cast<std::size_t>(std::ceil(length / std::clamp(beside, 0.01, farthestApart)));
    std::vector<StrokePoint> added(count, start);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(count - i) / static_cast<double>(count);
        added[i].pose.tip += glm::normalize(way) * (length * share);
        added[i].removes = added[i].onBoundary = false;
        added[i].arc.reset();
    }
    points.front().removes = points.front().onBoundary = false; // flags of the motion that now ends there
    points.insert(points.begin(), added.begin(), added.end());
}

} // namespace

Result<Deviation> apply(const Extend& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    for (PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) continue;
        extendStart(stroke.points, edit.atStart);
        PathStroke back = reversed(stroke);
        extendStart(back.points, edit.atEnd);
        stroke = reversed(back);
    }
    return Deviation{}; // existing points are unchanged
}

} // namespace burin
