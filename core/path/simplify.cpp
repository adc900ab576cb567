// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/parallel.h"
#include "core/path/back_steps.h"
#include "core/path/part_guard.h"
#include "core/path/polyline.h"

namespace burin {

Result<Deviation> apply(const Simplify& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    std::vector<Deviation> deviations(state.strokes.size());
    parallelFor(std::size_t{0}, state.strokes.size(), [&](std::size_t i) {
        PathStroke& stroke = state.strokes[i];
        const auto staysClear = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return !progress.cancelled() && guard->isClear(from, to, stroke.required, defaultSampling);
        };
        std::vector<std::size_t> kept = simplifyInGroups(stroke.points, edit.tolerance, staysClear, progress);
        const Deviation thinned = thinnedDeviation(stroke.points, kept);
        deviations[i] = dropBackSteps(stroke.points, kept, edit.tolerance, staysClear, progress);
        if (progress.cancelled()) return;
        deviations[i].include(thinned);
        keepOnly(stroke.points, kept);
    });
    Deviation deviation;
    for (const Deviation& one : deviations) deviation.include(one);
    return deviation;
}

} // namespace burin
