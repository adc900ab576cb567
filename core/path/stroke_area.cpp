// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stroke_area.h"

namespace burin {

DividedStroke divide(const PathStroke& stroke, const Area& area) {
    DividedStroke divided;
    for (const StrokePoint& point : stroke.points) {
        if (divided.points.empty()) {
            divided.points.push_back(point);
            divided.inside.push_back(holds(area, point.pose.tip));
            continue;
        }
        const StrokePoint from = divided.points.back();
        double before = 0.0;
        const auto add = [&](StrokePoint end, double share) {
            divided.inside.push_back(holds(area, glm::mix(from.pose.tip, point.pose.tip, 0.5 * (before + share))));
            divided.points.push_back(end);
            before = share;
        };
        for (const double share : crossings(area, from.pose.tip, point.pose.tip)) {
            StrokePoint between = point;
            between.sample = from.sample;
            between.pose.tip = glm::mix(from.pose.tip, point.pose.tip, share);
            add(between, share);
        }
        add(point, 1.0);
    }
    return divided;
}

} // namespace burin
