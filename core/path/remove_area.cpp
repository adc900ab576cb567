// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/stroke_area.h"

namespace burin {

Result<Deviation> apply(const RemoveArea& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    std::vector<PathStroke> left;
    for (const PathStroke& stroke : state.strokes) {
        const DividedStroke divided = divide(stroke, edit);
        PathStroke part = stroke;
        part.points.clear();
        const auto finish = [&] {
            if (part.points.size() > 1) left.push_back(part);
            part.points.clear();
        };
        for (std::size_t i = 0; i < divided.points.size(); ++i) {
            if (i > 0 && divided.inside[i]) finish(); // the move is deleted; the next one begins where it ended
            part.points.push_back(divided.points[i]);
        }
        const bool isPoint = divided.points.size() == 1;
        if (isPoint && !divided.inside.front())
            left.push_back(part);
        else
            finish();
    }
    state.strokes = std::move(left);
    return Deviation{}; // the remaining strokes are unchanged
}

} // namespace burin
