// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Spacing of the points of a stroke near one of its ends, mm.
double stepNear(const std::vector<StrokePoint>& points, bool atEnd) {
    constexpr std::size_t looked = 10;
    const std::size_t count = std::min(looked, points.size() - 1);
    const std::size_t first = atEnd ? points.size() - 1 - count : 0;
    double sum = 0.0;
    for (std::size_t i = first; i < first + count; ++i)
        sum += glm::distance(points[i].pose.tip, points[i + 1].pose.tip);
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

void append(PathStroke& stroke, const PathStroke& next) {
    constexpr double most = 10000.0; // points between
    const StrokePoint end = stroke.points.back(), start = next.points.front();
    const double step = 0.5 * (stepNear(stroke.points, true) + stepNear(next.points, false));
    const double moves = std::clamp(glm::distance(end.pose.tip, start.pose.tip) / std::max(step, 1e-6), 1.0, most);
    const auto count = static_cast<std::size_t>(std::ceil(moves));
    for (std::size_t i = 1; i < count; ++i) {
        StrokePoint between;
        between.pose.tip = glm::mix(end.pose.tip, start.pose.tip, static_cast<double>(i) / static_cast<double>(count));
        between.sample = end.sample;
        between.removes = true; // it cuts any material that it meets: not an air cut
        stroke.points.push_back(between);
    }
    stroke.points.insert(stroke.points.end(), next.points.begin(), next.points.end());
}

} // namespace

Result<Deviation> apply(const Join& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke> joined;
    for (PathStroke& stroke : state.strokes) {
        const bool follows =
            !joined.empty() && joined.back().source == stroke.source && touches(edit.interval, stroke) &&
            touches(edit.interval, joined.back()) &&
            glm::distance(joined.back().points.back().pose.tip, stroke.points.front().pose.tip) <= edit.longest;
        if (follows)
            append(joined.back(), stroke);
        else if (!stroke.points.empty())
            joined.push_back(std::move(stroke));
    }
    state.strokes = std::move(joined);
    return Deviation{};
}

} // namespace burin
