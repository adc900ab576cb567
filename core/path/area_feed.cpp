// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"
#include "core/path/apply.h"
#include "core/path/area.h"

#include <algorithm>

namespace burin {

Result<Deviation> apply(const AreaFeed& edit, PathUnderEdit& state, const PathContext& context, Progress&) {
    std::vector<PathPoint> points;
    const auto add = [&](PathPoint point, const glm::dvec3& middle) {
        if (holds(edit, middle)) {
            point.feed *= edit.factor;
            if (context.machine.maximumFeed > 0.0) point.feed = std::min(point.feed, context.machine.maximumFeed);
        }
        points.push_back(point);
    };
    for (const PathPoint& point : state.points) {
        if (points.empty() || point.kind == MoveKind::rapid || point.feed <= 0.0) {
            points.push_back(point);
            continue;
        }
        const glm::dvec3 from = points.back().pose.tip;
        if (point.arc) {
            const Arc arc{from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise};
            add(point, placeOn(arc, turnOf(arc), 0.5));
            continue;
        }
        std::vector<double> ends = crossings(edit, from, point.pose.tip);
        ends.push_back(1.0);
        double before = 0.0;
        for (const double share : ends) {
            PathPoint end = point;
            if (share < 1.0) end.pose.tip = glm::mix(from, point.pose.tip, share);
            add(end, glm::mix(from, point.pose.tip, 0.5 * (before + share)));
            before = share;
        }
    }
    state.points = std::move(points);
    return Deviation{};
}

} // namespace burin
