// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/drilled_holes.h"

#include "core/geometry/upright.h"

#include <algorithm>
#include <map>
#include <utility>

namespace burin {

namespace {

bool isPlumb(const PathPoint& from, const PathPoint& to) noexcept {
    return !to.arc && from.pose.tip.x == to.pose.tip.x && from.pose.tip.y == to.pose.tip.y;
}

PathPoint rapidTo(const PathPoint& point) {
    PathPoint rapid;
    rapid.pose = point.pose;
    rapid.kind = MoveKind::rapid;
    rapid.source = 0;
    rapid.sample = -1;
    return rapid;
}

} // namespace

void plungeAndReturn(std::vector<PathPoint>& points, double approach) {
    std::map<std::pair<double, double>, double> bottoms; // mm, by position in plan
    std::vector<PathPoint> hastened;
    bool fromRapid = false; // the tool came to this position by a rapid and has moved vertically since
    for (const PathPoint& point : points) {
        if (hastened.empty() || point.kind == MoveKind::rapid || !isPlumb(hastened.back(), point)) {
            fromRapid = point.kind == MoveKind::rapid;
            hastened.push_back(point);
            continue;
        }
        const double from = hastened.back().pose.tip.z, to = point.pose.tip.z;
        const auto place = std::pair(point.pose.tip.x, point.pose.tip.y);
        const auto bottom = bottoms.find(place);
        const bool drilled = bottom != bottoms.end();
        if (drilled && to > from && from >= bottom->second) {
            hastened.push_back(rapidTo(point));
            continue;
        }
        if (drilled && std::max(bottom->second + approach, to) < from) {
            hastened.push_back(rapidTo(point));
            hastened.back().pose.tip.z = std::max(bottom->second + approach, to);
        }
        if (fromRapid && to < from) bottoms[place] = std::min(to, drilled ? bottom->second : to);
        if (to == hastened.back().pose.tip.z) continue;
        hastened.push_back(point);
        // It cuts with its point only, which feed optimisation does not model.
        if (to < from) hastened.back().kind = MoveKind::plunge;
    }
    points = std::move(hastened);
}

} // namespace burin
