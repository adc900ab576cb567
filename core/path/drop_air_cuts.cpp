// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>

namespace burin {
namespace {

bool works(const StrokePoint& point) noexcept {
    return point.removes || point.onBoundary;
}

/// Length of the path from point `first` to point `last`, mm.
double lengthOf(const std::vector<StrokePoint>& points, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += glm::distance(points[i].pose.tip, points[i + 1].pose.tip);
    return sum;
}

/// Splits a stroke where it ran through air for too long, and keeps the remaining parts.
void cutUp(const PathStroke& stroke, double shortest, std::vector<PathStroke>& left) {
    const std::vector<StrokePoint>& points = stroke.points;
    if (std::ranges::none_of(points, works)) return; // nothing in it has to be machined
    PathStroke part = stroke;
    part.points.clear();
    const auto finish = [&] {
        if (!part.points.empty()) left.push_back(part);
        part.points.clear();
    };
    for (std::size_t i = 0; i < points.size();) {
        if (works(points[i])) {
            part.points.push_back(points[i++]);
            continue;
        }
        std::size_t end = i;
        while (end < points.size() && !works(points[end])) ++end;
        // Work at `end` was done on the move from the point before it, which therefore stays.
        const std::size_t from = i > 0 ? i - 1 : i, to = end - 1;
        if (lengthOf(points, from, to) > shortest) {
            finish();
            if (end < points.size()) part.points.push_back(points[end - 1]);
        } else {
            part.points.insert(part.points.end(), points.begin() + static_cast<std::ptrdiff_t>(i),
                               points.begin() + static_cast<std::ptrdiff_t>(end));
        }
        i = end;
    }
    finish();
}

} // namespace

Result<Deviation> apply(const DropAirCuts& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke> left;
    for (const PathStroke& stroke : state.strokes) cutUp(stroke, edit.shortest, left);
    state.strokes = std::move(left);
    return Deviation{}; // the remaining strokes are unchanged
}

} // namespace burin
