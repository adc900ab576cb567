// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

namespace burin {

Result<Deviation> apply(const Split& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke> strokes;
    for (PathStroke& stroke : state.strokes) {
        if (!holds(stroke, edit.at)) {
            strokes.push_back(std::move(stroke));
            continue;
        }
        PathStroke part{stroke.source, stroke.allowance, stroke.required, stroke.tickPeriod, {}};
        const bool backwards = stroke.points.front().sample > stroke.points.back().sample;
        bool split = false;
        for (const StrokePoint& point : stroke.points) {
            part.points.push_back(point);
            const bool there = backwards ? point.sample <= edit.at.tick : point.sample >= edit.at.tick;
            if (split || !there || part.points.size() < 2 || &point == &stroke.points.back()) continue;
            strokes.push_back(part);
            part.points = {point};
            split = true;
        }
        strokes.push_back(std::move(part));
    }
    state.strokes = std::move(strokes);
    return Deviation{};
}

} // namespace burin
