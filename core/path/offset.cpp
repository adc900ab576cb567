// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/plan_offset.h"

#include "core/base/parallel.h"

namespace burin {

Result<Deviation> apply(const Offset& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    std::vector<std::vector<std::vector<StrokePoint>>> pieces(state.strokes.size());
    parallelFor(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        const PathStroke& stroke = state.strokes[i];
        if (!progress.cancelled() && touches(edit.interval, stroke))
            pieces[i] = offsetInPlan(stroke.points, edit.distance);
        else
            pieces[i] = {stroke.points};
    });
    std::vector<PathStroke> strokes;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PathStroke& from = state.strokes[i];
        for (std::vector<StrokePoint>& points : pieces[i])
            strokes.push_back({from.source, from.allowance, from.required, from.tickPeriod, std::move(points)});
    }
    state.strokes = std::move(strokes);
    return Deviation{}; // changed on purpose
}

} // namespace burin
