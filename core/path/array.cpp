// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/upright_turn.h"

namespace burin {

Result<Deviation> apply(const Array& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    constexpr std::size_t most = 20'000'000; // points; some 1.3 GB
    std::vector<PathStroke> originals;
    std::size_t count = 0;
    for (const PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) continue;
        originals.push_back(stroke);
        count += stroke.points.size();
    }
    const auto copies = static_cast<std::size_t>(edit.copies);
    if (count * copies > most)
        return Error{ErrorCode::argumentInvalid, "copies", std::to_string(copies),
                     "no more than " + std::to_string(most / count) + " of so long a path"};
    for (std::size_t k = 1; k <= copies; ++k) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, context.tool.id, "", ""};
        const double times = static_cast<double>(k);
        const UprightTurn turn(edit.centre, times * edit.turn);
        for (PathStroke copy : originals) {
            for (StrokePoint& point : copy.points) point.pose.tip = turn.turned(point.pose.tip) + times * edit.step;
            state.strokes.push_back(std::move(copy));
        }
    }
    return Deviation{};
}

} // namespace burin
