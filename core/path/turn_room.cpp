// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/turn_room.h"

#include <cmath>

namespace burin {

std::optional<glm::dvec3> turnBeyond(const glm::dvec3& end, const glm::dvec3& before) {
    const glm::dvec3 last = end - before;
    const double level = std::hypot(last.x, last.y);
    if (glm::length(last) >= turnRoom || level == 0.0) return std::nullopt;
    return end + turnRoom / level * glm::dvec3(last.x, last.y, 0.0);
}

std::optional<PathStroke> withLongStart(const PathStroke& stroke, const PartGuard& guard, Deviation& deviation) {
    const std::vector<StrokePoint>& points = stroke.points;
    const glm::dvec3& start = points.front().pose.tip;
    for (std::size_t to = 2; to < points.size() && !points[to - 1].arc && !points[to].arc; ++to) {
        const glm::dvec3& end = points[to].pose.tip;
        Deviation left;
        for (std::size_t i = 1; i < to; ++i)
            left.include(distanceToSegment(points[i].pose.tip, start, end), points[i].pose.tip);
        if (left.distance > backStepTolerance) return std::nullopt;
        if (glm::distance(start, end) < turnRoom) continue;
        if (!guard.isClear(start, end, stroke.required, defaultSampling)) return std::nullopt;
        PathStroke longer = stroke;
        longer.points.erase(longer.points.begin() + 1, longer.points.begin() + static_cast<std::ptrdiff_t>(to));
        deviation.include(left);
        return longer;
    }
    return std::nullopt;
}

PathStroke turnable(const PathStroke& line, const std::vector<StrokeStep>& steps, std::size_t wanted,
                    std::size_t usable) {
    const auto lastMove = [&](std::size_t step) {
        std::size_t corner = step;
        while (corner > 0 && steps[corner].position.move == steps[step].position.move) --corner;
        return steps[step].at - steps[corner].at;
    };
    std::size_t end = wanted;
    while (end < usable && lastMove(end) < turnRoom) ++end;
    if (lastMove(end) < turnRoom) end = wanted;
    PathStroke forth = between(line, {0, 1.0}, steps[end].position);
    StrokePoint& last = forth.points.back();
    const glm::dvec3& corner = forth.points[forth.points.size() - 2].pose.tip;
    const double length = glm::distance(last.pose.tip, corner);
    if (!last.arc && length < turnRoom && length > 0.0)
        last.pose.tip = corner + turnRoom / length * (last.pose.tip - corner);
    return forth;
}

} // namespace burin
