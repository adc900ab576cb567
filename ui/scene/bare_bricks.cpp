// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bare_bricks.h"

#include <algorithm>
#include <tuple>

namespace burin {

namespace {

constexpr int voxelsPerSide = linesPerSurfaceTile; // voxels
/// How far the part is drawn beyond its bare regions, cells: where stock ends on it, and as far as a flat view
/// direction sees beneath the stock.
constexpr int seenBeyond = 4;

glm::ivec3 gridAxes(const Grid& grid) {
    return {grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
}

template <class Vector>
Vector byAxes(const glm::ivec3& axes, const Vector& vector) {
    return {vector[axes.x], vector[axes.y], vector[axes.z]};
}

glm::ivec3 brickCount(const Grid& grid) {
    return (byAxes(gridAxes(grid), grid.count()) + voxelsPerSide - 1) / voxelsPerSide;
}

} // namespace

BareBricks::BareBricks(const Grid& grid)
    : axes_(gridAxes(grid))
    , count_(brickCount(grid))
    , low_(byAxes(axes_, glm::vec3(grid.box().low)))
    , high_(byAxes(axes_, glm::vec3(grid.box().high)))
    , slack_(static_cast<float>(0.5 * grid.edge()))
    , perMillimetre_(static_cast<float>(1.0 / (voxelsPerSide * grid.edge())))
    , marks_(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
             static_cast<std::size_t>(count_.z)) {}

void BareBricks::mark(std::span<const SurfaceBrick> bricks) {
    for (const SurfaceBrick& brick : bricks) markOf(brick) = 1;
    any_ = any_ || !bricks.empty();
}

bool BareBricks::touches(const glm::vec3& low, const glm::vec3& high) const {
    const glm::vec3 from = byAxes(axes_, low), to = byAxes(axes_, high);
    if (glm::any(glm::lessThan(from, low_ - slack_)) || glm::any(glm::greaterThan(to, high_ + slack_))) return true;
    if (!any_) return false;
    const glm::ivec3 first = glm::min(glm::ivec3((from - low_) * perMillimetre_), count_ - 1);
    const glm::ivec3 last = glm::min(glm::ivec3((to - low_) * perMillimetre_), count_ - 1);
    for (int v = first.y; v <= last.y; ++v)
        for (int u = first.x; u <= last.x; ++u)
            for (int n = first.z; n <= last.z; ++n)
                if (marks_[placeOf(u, v, n)] != 0) return true;
    return false;
}

void findBareBricks(const VolumeSnapshot& workpiece, int level, const SurfaceMesh& mesh,
                    std::vector<SurfaceBrick>& found) {
    const Grid& grid = workpiece.grid();
    const glm::ivec3 axes = gridAxes(grid), end = brickCount(grid) - 1;
    const glm::vec3 gridLow = byAxes(axes, glm::vec3(grid.low()));
    const auto perMillimetre = static_cast<float>(1.0 / (voxelsPerSide * grid.edge()));
    const float reach = static_cast<float>(seenBeyond << level) / voxelsPerSide;
    glm::ivec3 lastLow(-1), lastHigh(-1);
    found.clear();
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        if (!workpiece.properties().isProtected(mesh.properties[point])) continue;
        const glm::vec3 place = (byAxes(axes, mesh.points[point]) - gridLow) * perMillimetre;
        const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(place - reach)), glm::ivec3(0), end);
        const glm::ivec3 high = glm::clamp(glm::ivec3(glm::floor(place + reach)), glm::ivec3(0), end);
        if (low == lastLow && high == lastHigh) continue; // as for most points
        lastLow = low;
        lastHigh = high;
        for (int v = low.y; v <= high.y; ++v)
            for (int u = low.x; u <= high.x; ++u)
                for (int n = low.z; n <= high.z; ++n) found.push_back({u, v, n});
    }
    const auto key = [](const SurfaceBrick& brick) { return std::tuple(brick.v, brick.u, brick.n); };
    std::ranges::sort(found, {}, key);
    found.erase(std::ranges::unique(found).begin(), found.end());
}

} // namespace burin
