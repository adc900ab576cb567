// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_removal.h"

#include "core/cutting/removal.h"
#include "core/geometry/arc.h"
#include "core/geometry/upright.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

Error fullMemory(const RunVolume& stock) {
    return {ErrorCode::volumeOutOfMemory, std::to_string(stock.reservedBytes()), "", ""};
}

/// A straight move on which the tool turns, in steps of a voxel.
Result<void> cutTilted(const ToolPose& from, const ToolPose& to, MaterialRemoval& removal, RunVolume& stock) {
    const double length = glm::distance(from.tip, to.tip);
    const auto steps = static_cast<int>(std::max(1.0, std::ceil(length / stock.grid().edge())));
    ToolPose at = from;
    for (int k = 1; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        const ToolPose next{glm::mix(from.tip, to.tip, share), glm::normalize(glm::mix(from.axis, to.axis, share))};
        if (removal.cut(stock, at, next).outOfMemory) return fullMemory(stock);
        at = next;
    }
    return {};
}

Result<void> cutMoves(const Path& path, MaterialRemoval& removal, RunVolume& stock, Progress& progress) {
    const double chord = 0.02 * stock.grid().edge();
    std::vector<glm::dvec3> places;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, path.name, "", ""};
        progress.report(static_cast<double>(i) / static_cast<double>(path.points.size()));
        const PathPoint& point = path.points[i];
        if (point.kind == MoveKind::rapid) continue;
        glm::dvec3 from = path.points[i - 1].pose.tip;
        places = {point.pose.tip};
        if (point.arc)
            flatten({from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise}, chord, places);
        const ToolPose& start = path.points[i - 1].pose;
        if (!isUpright(start.axis) || !isUpright(point.pose.axis)) {
            if (Result<void> done = cutTilted(start, point.pose, removal, stock); !done) return done;
            continue;
        }
        for (const glm::dvec3& to : places) {
            if (removal.cut(stock, from, to).outOfMemory) return fullMemory(stock);
            from = to;
        }
    }
    return {};
}

} // namespace

Result<void> cutPath(const Path& path, const Cutter& cutter, RunVolume& stock, Progress& progress) {
    MaterialRemoval removal(cutter, stock.grid(), Writing::deferred);
    Result<void> done = cutMoves(path, removal, stock, progress);
    // Also after an interruption: reserved memory is returned to the stock.
    const bool full = removal.settle(stock).outOfMemory;
    if (done && full) return fullMemory(stock);
    return done;
}

} // namespace burin
