// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/path/apply.h"
#include "core/path/lead.h"

namespace burin {

/// A lead-in of the reversed stroke.
Result<Deviation> apply(const LeadOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    const auto form = edit.form == LeadOut::Form::line ? LeadIn::Form::line : LeadIn::Form::arc;
    const LeadFinder finder({form, edit.size, 0.0, 0.0}, *guard, context);
    const bool byHand = edit.direction == LeadDirection::recording;
    parallelFor(std::size_t{0}, state.strokes.size(), [&](std::size_t i) {
        if (progress.cancelled() || !touches(edit.interval, state.strokes[i])) return;
        PathStroke back = reversed(state.strokes[i]);
        const std::optional<HandStart> start = byHand ? startOf(back, state) : std::nullopt;
        const std::vector<StrokePoint> way = finder.into(back, start ? &*start : nullptr);
        if (way.empty()) return;
        back.points.front().arc = way.back().arc;
        back.points.insert(back.points.begin(), way.begin(), way.end() - 1);
        state.strokes[i] = reversed(back);
    });
    return Deviation{}; // the stroke itself is unchanged
}

} // namespace burin
