// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/path_lines.h"

#include "core/geometry/arc.h"

#include <utility>

namespace burin {

void addMove(std::vector<LineEnds>& lines, const glm::dvec3& from, const PathPoint& point) {
    if (!point.arc) {
        lines.emplace_back(from, point.pose.tip);
        return;
    }
    constexpr double drawnChord = 0.02; // mm
    std::vector<glm::dvec3> places;
    flatten({from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise}, drawnChord, places);
    glm::dvec3 last = from;
    for (const glm::dvec3& place : places) lines.emplace_back(std::exchange(last, place), place);
}

std::vector<LineEnds> millingLines(const Path& path) {
    std::vector<LineEnds> lines;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].kind == MoveKind::cut || path.points[i].kind == MoveKind::plunge)
            addMove(lines, path.points[i - 1].pose.tip, path.points[i]);
    return lines;
}

} // namespace burin
