// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>

namespace burin {
namespace {

/// Removes this length from the start.
void trimStart(std::vector<StrokePoint>& points, double length) {
    if (!(length > 0.0)) return;
    std::size_t i = 1;
    for (; i < points.size(); ++i) {
        const double move = glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
        if (move > length) break;
        length -= move;
    }
    if (i >= points.size()) {
        points.clear();
        return;
    }
    StrokePoint start = points[i - 1];
    const glm::dvec3 way = points[i].pose.tip - start.pose.tip;
    start.pose.tip += way * (length / glm::length(way));
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
    points.insert(points.begin(), start);
}

} // namespace

Result<Deviation> apply(const Trim& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    for (PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) continue;
        trimStart(stroke.points, edit.fromStart);
        std::ranges::reverse(stroke.points);
        const StrokePoint last = stroke.points.empty() ? StrokePoint{} : stroke.points.front();
        trimStart(stroke.points, edit.fromEnd);
        if (!stroke.points.empty() && edit.fromEnd > 0.0) { // the flags of the move to the new end apply to it
            stroke.points.front().removes = stroke.points.front().removes || last.removes;
            stroke.points.front().onBoundary = stroke.points.front().onBoundary || last.onBoundary;
        }
        std::ranges::reverse(stroke.points);
    }
    std::erase_if(state.strokes, [](const PathStroke& stroke) { return stroke.points.empty(); });
    return Deviation{}; // the remaining strokes are unchanged
}

} // namespace burin
