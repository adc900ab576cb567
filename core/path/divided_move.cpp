// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/divided_move.h"

#include <algorithm>
#include <cmath>

namespace burin {

void addDivided(std::vector<StrokePoint>& points, const StrokePoint& point, double apart) {
    if (!points.empty()) {
        const StrokePoint before = points.back();
        const double length = glm::distance(before.pose.tip, point.pose.tip);
        const auto steps = static_cast<int>(std::max(1.0, std::ceil(length / apart)));
        for (int k = 1; k < steps; ++k) {
            StrokePoint between = point;
            between.sample = before.sample;
            between.pose.tip = glm::mix(before.pose.tip, point.pose.tip, static_cast<double>(k) / steps);
            points.push_back(between);
        }
    }
    points.push_back(point);
}

} // namespace burin
