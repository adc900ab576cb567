// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

namespace burin {

Result<Deviation> apply(const CutOut& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke> left;
    for (PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) {
            left.push_back(std::move(stroke));
            continue;
        }
        bool begins = true;
        for (const StrokePoint& point : stroke.points) {
            const bool goes = contains(edit.interval, stroke, point);
            if (!goes && begins)
                left.push_back({stroke.source, stroke.allowance, stroke.required, stroke.tickPeriod, {}});
            if (!goes) left.back().points.push_back(point);
            begins = goes;
        }
    }
    state.strokes = std::move(left);
    return Deviation{}; // the remaining strokes are unchanged
}

} // namespace burin
