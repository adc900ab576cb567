// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/lowering.h"

#include "core/base/parallel.h"
#include "core/geometry/lowest_clear.h"
#include "core/path/divided_move.h"

#include <algorithm>
#include <cmath>

namespace burin {
std::optional<glm::dvec3> Lowering::alongAxis(const glm::dvec3& tip) const {
    const auto spareAt = [&](double z) {
        return guard_.clearance({tip.x, tip.y, z}, distance_ + 1e3).clearance - distance_;
    };
    constexpr double above = 0.02; // mm, height of a tip above the part
    const std::optional<double> height =
        lowestClear(spareAt, std::max(guard_.top() + distance_ + above, floor_), floor_);
    if (!height) return {};
    return glm::dvec3{tip.x, tip.y, *height};
}

std::optional<glm::dvec3> Lowering::alongNormal(glm::dvec3 tip) const {
    constexpr int attempts = 40;
    for (int i = 0; i < attempts; ++i) {
        const ToolClearance now = guard_.clearance(tip, 1e3);
        const double missing = distance_ - now.clearance;
        if (std::abs(missing) <= touchPrecision) return tip;
        tip += missing * now.away;
    }
    return {};
}

std::vector<PathStroke> lowered(const PathStroke& stroke, const Lowering& lowering, double sampling,
                                const Progress& progress) {
    std::vector<StrokePoint> places;
    for (const StrokePoint& point : stroke.points) addDivided(places, point, sampling);
    std::vector<std::optional<glm::dvec3>> tips(places.size());
    parallelFor(std::size_t{0}, places.size(), [&](std::size_t i) {
        if (!progress.cancelled()) tips[i] = lowering.bring(places[i].pose.tip);
    });
    std::vector<PathStroke> strokes;
    bool begins = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (tips[i] && begins)
            strokes.push_back({stroke.source, stroke.allowance, stroke.required, stroke.tickPeriod, {}});
        begins = !tips[i];
        if (begins) continue;
        places[i].pose.tip = *tips[i];
        places[i].removes = places[i].onBoundary = true; // it lies on the part: not an air cut
        strokes.back().points.push_back(places[i]);
    }
    return strokes;
}

} // namespace burin
