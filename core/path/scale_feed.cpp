// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include <algorithm>

namespace burin {

Result<Deviation> apply(const ScaleFeed& edit, PathUnderEdit& state, const PathContext& context, Progress&) {
    for (PathPoint& point : state.points) {
        if (point.kind == MoveKind::rapid || point.sample < 0) continue;
        if (!edit.interval.contains({point.source, point.sample})) continue;
        point.feed *= edit.factor;
        if (context.machine.maximumFeed > 0.0) point.feed = std::min(point.feed, context.machine.maximumFeed);
    }
    return Deviation{};
}

} // namespace burin
