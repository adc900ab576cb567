// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Points along straight lines through all given points, about `count` in total, evenly spaced as far as possible.
std::vector<StrokePoint> pointsAlong(const std::vector<glm::dvec3>& places, std::size_t count, std::int64_t first,
                                     std::int64_t last) {
    double length = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i) length += glm::distance(places[i - 1], places[i]);
    std::vector<StrokePoint> points;
    const auto add = [&](const glm::dvec3& tip) {
        StrokePoint point;
        point.pose.tip = tip;
        point.removes = true; // requested by the user: not an air cut
        points.push_back(point);
    };
    add(places.front());
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double share = length > 0.0 ? glm::distance(places[i - 1], places[i]) / length : 0.0;
        const auto moves = static_cast<std::size_t>(std::max(1.0, std::round(share * static_cast<double>(count - 1))));
        for (std::size_t k = 1; k <= moves; ++k)
            add(glm::mix(places[i - 1], places[i], static_cast<double>(k) / static_cast<double>(moves)));
    }
    for (std::size_t i = 0; i < points.size(); ++i) // the hand's moments, evenly distributed
        points[i].sample = first + static_cast<std::int64_t>(
                                       std::llround(static_cast<double>(last - first) * static_cast<double>(i) /
                                                    static_cast<double>(std::max<std::size_t>(1, points.size() - 1))));
    return points;
}

/// @return whether the stroke has the interval
bool replace(PathStroke& stroke, const ReplaceInterval& edit) {
    std::vector<StrokePoint>& points = stroke.points;
    const auto inside = [&](const StrokePoint& point) { return contains(edit.interval, stroke, point); };
    const auto first = std::ranges::find_if(points, inside);
    if (first == points.end()) return false;
    const auto behind = std::find_if(points.rbegin(), points.rend(), inside).base();
    const std::vector<StrokePoint> made =
        pointsAlong(edit.places, static_cast<std::size_t>(behind - first), first->sample, std::prev(behind)->sample);
    points.insert(points.erase(first, behind), made.begin(), made.end());
    return true;
}

} // namespace

Result<Deviation> apply(const ReplaceInterval& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    if (edit.places.empty()) return Deviation{};
    bool found = false;
    for (PathStroke& stroke : state.strokes) found = replace(stroke, edit) || found;
    if (!found)
        return Error{ErrorCode::argumentInvalid, "stretch", "take " + std::to_string(edit.interval.source),
                     "moments that the path still has"};
    return Deviation{}; // changed on purpose
}

} // namespace burin
