// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/stroke_area.h"

namespace burin {

Result<Deviation> apply(const LiftArea& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    if (!(edit.lift > 0.0)) return Deviation{};
    const glm::dvec3 up(0.0, 0.0, edit.lift);
    for (PathStroke& stroke : state.strokes) {
        const DividedStroke divided = divide(stroke, edit);
        std::vector<StrokePoint> lifted;
        bool high = false;
        for (std::size_t i = 0; i < divided.points.size(); ++i) {
            if (divided.inside[i] != high && i > 0) { // at the border, where the move before ended
                StrokePoint step = divided.points[i - 1];
                step.removes = step.onBoundary = false;
                if (divided.inside[i]) step.pose.tip += up;
                lifted.push_back(step);
            }
            high = divided.inside[i];
            StrokePoint point = divided.points[i];
            if (high) point.pose.tip += up;
            lifted.push_back(point);
        }
        stroke.points = std::move(lifted);
    }
    return Deviation{}; // changed on purpose
}

} // namespace burin
