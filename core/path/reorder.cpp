// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>

namespace burin {

Result<Deviation> apply(const Reorder& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke>& strokes = state.strokes;
    const auto placeOf = [&](const Moment& moment) {
        return std::ranges::find_if(strokes, [&](const PathStroke& stroke) { return holds(stroke, moment); });
    };
    const auto moved = placeOf(edit.stroke), before = placeOf(edit.before);
    if (moved == strokes.end() || moved == before) return Deviation{};
    if (moved < before)
        std::rotate(moved, moved + 1, before);
    else
        std::rotate(before, moved, moved + 1);
    return Deviation{};
}

} // namespace burin
