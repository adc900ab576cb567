// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/engagement_record.h"

#include "core/cutting/removal.h"
#include "core/geometry/arc.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Ends of the intervals of a move, with the fraction of the move at which each ends.
std::vector<std::pair<glm::dvec3, double>> intervalsOf(const glm::dvec3& from, const PathPoint& to, double sampling) {
    std::vector<std::pair<glm::dvec3, double>> ends;
    if (!to.arc) {
        const auto count = static_cast<int>(std::max(1.0, std::ceil(glm::distance(from, to.pose.tip) / sampling)));
        for (int i = 1; i <= count; ++i)
            ends.emplace_back(glm::mix(from, to.pose.tip, static_cast<double>(i) / count),
                              static_cast<double>(i) / count);
        return ends;
    }
    const Arc arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
    const ArcTurn turn = turnOf(arc);
    const double length = lengthOf(arc, turn);
    const auto count = static_cast<int>(std::max(1.0, std::ceil(length / sampling)));
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        ends.emplace_back(placeOn(arc, turn, share), share);
    }
    return ends;
}

/// Steps short enough for the smooth values of MaterialRemoval, in voxels.
constexpr double longestStep = 0.25;

void add(MetInterval& met, const CutResult& cut) {
    for (const MaterialVolume& material : cut.removed) {
        if (material.property == airProperty) break;
        auto mine = std::ranges::find(met.removed, material.property, &MaterialVolume::property);
        if (mine == met.removed.end()) mine = met.removed.insert(mine, MaterialVolume{material.property, 0, 0.0, 0.0});
        mine->units += material.units;
        mine->volume += material.volume;
        mine->reported += material.reported;
    }
    met.reported += cut.reported;
    if (cut.reported > 0.0) met.centroid = cut.reportedCentroid;
    if (cut.engagement.area > 0.0) met.engagement = cut.engagement;
}

/// @return false if the memory is used up
bool cutInterval(MaterialRemoval& removal, RunVolume& stock, MetInterval& met, RecordGrain grain) {
    const double step = longestStep * stock.grid().edge();
    const auto steps = grain == RecordGrain::coarse ? 1 : static_cast<int>(std::max(1.0, std::ceil(met.length / step)));
    glm::dvec3 at = met.from;
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 next = glm::mix(met.from, met.to, static_cast<double>(i) / steps);
        const CutResult cut = removal.cut(stock, at, next);
        if (cut.outOfMemory) return false;
        add(met, cut);
        at = next;
    }
    return true;
}

} // namespace

CutResult MetInterval::cut() const {
    CutResult result;
    std::ranges::copy(removed, result.removed.begin());
    result.reported = reported;
    result.reportedCentroid = centroid;
    result.engagement = engagement;
    return result;
}

Result<std::vector<MetInterval>> recordEngagement(const std::vector<PathPoint>& points, const Tool& tool,
                                                  RunVolume& stock, double sampling, Progress& progress,
                                                  RecordGrain grain) {
    MaterialRemoval removal(tool.cutter, stock.grid());
    std::vector<MetInterval> record;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
        if (points[i].kind == MoveKind::rapid) continue;
        glm::dvec3 from = points[i - 1].pose.tip;
        for (const auto& [to, share] : intervalsOf(from, points[i], sampling)) {
            MetInterval met{i, share, glm::distance(from, to), from, to, {}, 0.0, {}, {}};
            if (!cutInterval(removal, stock, met, grain))
                return Error{ErrorCode::volumeOutOfMemory, std::to_string(stock.reservedBytes()), "", ""};
            record.push_back(std::move(met));
            from = to;
        }
    }
    return record;
}

} // namespace burin
