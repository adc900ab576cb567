// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/path/apply.h"
#include "core/path/lead.h"

namespace burin {

Result<Deviation> apply(const LeadIn& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    const LeadFinder finder({edit.form, edit.size, edit.height, edit.angle}, *guard, context);
    const bool byHand = edit.direction == LeadDirection::recording;
    parallelFor(std::size_t{0}, state.strokes.size(), [&](std::size_t i) {
        PathStroke& stroke = state.strokes[i];
        if (progress.cancelled() || !touches(edit.interval, stroke)) return;
        const std::optional<HandStart> start = byHand ? startOf(stroke, state) : std::nullopt;
        const std::vector<StrokePoint> way = finder.into(stroke, start ? &*start : nullptr);
        if (way.empty()) return;
        stroke.points.front().arc = way.back().arc; // the stroke's own start is the end of the lead-in
        stroke.points.insert(stroke.points.begin(), way.begin(), way.end() - 1);
    });
    return Deviation{}; // the stroke itself is unchanged
}

} // namespace burin
