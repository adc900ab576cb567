// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/upright_turn.h"

namespace burin {

Result<Deviation> apply(const Rotate& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    const UprightTurn turn(edit.centre, edit.angle);
    for (PathStroke& stroke : state.strokes) {
        if (!touches(edit.interval, stroke)) continue;
        for (StrokePoint& point : stroke.points) point.pose.tip = turn.turned(point.pose.tip);
    }
    return Deviation{};
}

} // namespace burin
