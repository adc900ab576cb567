// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_removal.h"

#include "core/cutting/removal.h"
#include "core/geometry/arc.h"

namespace burin {

namespace {

Error fullMemory(const RunVolume& stock) {
    return {ErrorCode::volumeOutOfMemory, std::to_string(stock.reservedBytes()), "", ""};
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
