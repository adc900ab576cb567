// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>

namespace burin {
namespace {

/// What a motion did stays with it, though it ends at its other end now.
void reverse(std::vector<StrokePoint>& points) {
    std::ranges::reverse(points);
    for (std::size_t i = points.size(); i-- > 1;) {
        points[i].removes = points[i - 1].removes;
        points[i].onBoundary = points[i - 1].onBoundary;
    }
}

} // namespace

Result<Deviation> apply(const Reverse& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    for (PathStroke& stroke : state.strokes)
        if (touches(edit.stretch, stroke)) reverse(stroke.points);
    return Deviation{};
}

} // namespace burin
