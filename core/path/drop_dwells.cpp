// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/path/polyline.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Speed is measured over this time, one period of tremor, so that tremor about a fixed position does not count as
/// motion.
constexpr double speedWindow = 0.1; // s
/// A slowly moving tip keeps a point at each of these distances from the last one kept, so that the path's shape stays.
constexpr double creep = 0.05; // mm

/// Points at which the tool stands still, by the length of the motion around each of them.
std::vector<bool> slowPoints(const PathStroke& stroke, double speed) {
    const std::vector<StrokePoint>& points = stroke.points;
    const auto half = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * speedWindow / stroke.tickPeriod)));
    std::vector<bool> slow(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t low = i > half ? i - half : 0, high = std::min(i + half, points.size() - 1);
        if (high == low) continue;
        const double time = static_cast<double>(high - low) * stroke.tickPeriod;
        slow[i] = glm::distance(points[low].pose.tip, points[high].pose.tip) < speed * time && !points[i].removes;
    }
    return slow;
}

Deviation dropDwells(PathStroke& stroke, const DropDwells& edit) {
    if (!stroke.inTime()) return {};
    const std::vector<bool> slow = slowPoints(stroke, edit.speed);
    std::vector<StrokePoint>& points = stroke.points;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points.size();) {
        std::size_t end = i;
        while (end < points.size() && slow[end]) ++end;
        const bool dwells = static_cast<double>(end - i) * stroke.tickPeriod > edit.time;
        if (!dwells) end = std::max(end, i + 1);
        for (; i < end; ++i) {
            const bool isEnd = i == 0 || i + 1 == end;
            if (!dwells || isEnd || glm::distance(points[i].pose.tip, points[kept.back()].pose.tip) >= creep)
                kept.push_back(i);
        }
    }
    const Deviation deviation = thinnedDeviation(points, kept);
    keepOnly(points, kept);
    return deviation;
}

} // namespace

Result<Deviation> apply(const DropDwells& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    Deviation deviation;
    for (PathStroke& stroke : state.strokes) deviation.include(dropDwells(stroke, edit));
    return deviation;
}

} // namespace burin
