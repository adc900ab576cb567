// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

namespace burin {

Result<Deviation> apply(const Mirror& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    const int axis = edit.across == Mirror::Across::x ? 0 : 1;
    std::vector<PathStroke> images;
    for (PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) continue;
        if (edit.keep) images.push_back(stroke);
        PathStroke& image = edit.keep ? images.back() : stroke;
        for (StrokePoint& point : image.points) point.pose.tip[axis] = 2.0 * edit.at - point.pose.tip[axis];
    }
    for (PathStroke& image : images) state.strokes.push_back(std::move(image));
    return Deviation{};
}

} // namespace burin
