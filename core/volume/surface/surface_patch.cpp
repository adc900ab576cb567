// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_patch.h"

#include "core/geometry/pose.h"
#include "core/geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace burin {

namespace {

constexpr double linkedWithin = 1.9; ///< voxels: neighbours in a net have a point in cubes that share a corner

/// Bricks of a surface, counted along u, v and the runs.
class PatchBricks {
public:
    explicit PatchBricks(const Grid& grid) : grid_(grid) {
        const glm::ivec2 tiles = surfaceTiles(grid);
        count_ = {tiles.x, tiles.y, (grid.voxelsPerLine() + linesPerSurfaceTile - 1) / linesPerSurfaceTile};
    }
    const glm::ivec3& count() const noexcept { return count_; }
    double edge() const noexcept { return grid_.edge() * linesPerSurfaceTile; }
    /// The brick that contains a place, or the nearest one.
    glm::ivec3 at(const glm::dvec3& place) const {
        const glm::dvec3 from = (place - grid_.low()) / edge();
        const glm::dvec3 inOrder(from[grid_.axisOfU()], from[grid_.axisOfV()], from[grid_.axisOfRuns()]);
        return {glm::clamp(glm::floor(inOrder), glm::dvec3(0.0), glm::dvec3(count_ - 1))};
    }

private:
    const Grid& grid_;
    glm::ivec3 count_{0};
};

/// Calls `visit` with each brick whose distance from one of them, counted in bricks along the farthest axis, is `ring`.
template <typename Visit>
void visitRing(const glm::ivec3& around, int ring, const glm::ivec3& count, const Visit& visit) {
    const glm::ivec3 low = glm::max(around - ring, glm::ivec3(0)), high = glm::min(around + ring, count - 1);
    for (int u = low.x; u <= high.x; ++u)
        for (int v = low.y; v <= high.y; ++v) {
            const bool side = std::abs(u - around.x) == ring || std::abs(v - around.y) == ring;
            for (int n = low.z; n <= high.z; ++n)
                if (side || std::abs(n - around.z) == ring) visit(SurfaceBrick{u, v, n});
        }
}

/// Cells of a hash of places.
struct CellOf {
    double size;
    glm::i64vec3 operator()(const glm::dvec3& place) const { return glm::i64vec3(glm::floor(place / size)); }
};

struct CellHash {
    std::size_t operator()(const glm::i64vec3& cell) const noexcept {
        const auto mixed = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15U ^
                           static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4FU ^
                           static_cast<std::uint64_t>(cell.z) * 0x165667B19E3779F9U;
        return static_cast<std::size_t>(mixed ^ (mixed >> 29U));
    }
};

using Cells = std::unordered_map<glm::i64vec3, std::vector<std::uint32_t>, CellHash>;

/// Calls `visit` with the numbers in a cell and in those around it.
template <typename Visit>
void visitAround(const Cells& cells, const glm::i64vec3& cell, const Visit& visit) {
    for (std::int64_t i = -1; i <= 1; ++i)
        for (std::int64_t j = -1; j <= 1; ++j)
            for (std::int64_t k = -1; k <= 1; ++k)
                if (const auto found = cells.find(cell + glm::i64vec3(i, j, k)); found != cells.end())
                    for (const std::uint32_t number : found->second) visit(number);
}

} // namespace

std::optional<SurfacePoint> nearestOnSurface(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    if (workpiece.empty() || !isFinite(place)) return std::nullopt;
    const PatchBricks bricks(workpiece.grid());
    const glm::ivec3 around = bricks.at(place);
    const glm::ivec3 farthest = glm::max(around, bricks.count() - 1 - around);
    const int rings = std::max({farthest.x, farthest.y, farthest.z});
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    std::optional<SurfacePoint> nearest;
    double best = std::numeric_limits<double>::infinity();
    for (int ring = 0; ring <= rings && best > (ring - 1) * bricks.edge(); ++ring)
        visitRing(around, ring, bricks.count(), [&](const SurfaceBrick& brick) {
            extractor.extractBrick(workpiece, brick, mesh);
            for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
                const Triangle corners{glm::dvec3(mesh.points[mesh.triangles[i]]),
                                       glm::dvec3(mesh.points[mesh.triangles[i + 1]]),
                                       glm::dvec3(mesh.points[mesh.triangles[i + 2]])};
                const glm::dvec3 point = closestOnTriangle(corners, place).point;
                const double distance = glm::distance(point, place);
                if (distance >= best) continue;
                best = distance;
                nearest = SurfacePoint{point, unitNormal(corners)};
            }
        });
    return nearest;
}

SurfacePatch::SurfacePatch(const VolumeSnapshot& workpiece, const glm::dvec3& place, double reach) {
    gather(workpiece, place, reach);
    link(linkedWithin * workpiece.grid().edge());
}

/// Bricks share the points along their borders, which are kept once.
void SurfacePatch::gather(const VolumeSnapshot& workpiece, const glm::dvec3& place, double reach) {
    const double edge = workpiece.grid().edge(), same = 0.02 * edge;
    const PatchBricks bricks(workpiece.grid());
    const glm::ivec3 low = bricks.at(place - reach), high = bricks.at(place + reach);
    const CellOf cellOf{edge};
    Cells cells;
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    for (int u = low.x; u <= high.x; ++u)
        for (int v = low.y; v <= high.y; ++v)
            for (int n = low.z; n <= high.z; ++n) {
                extractor.extractBrick(workpiece, {u, v, n}, mesh);
                for (std::size_t i = 0; i < mesh.points.size(); ++i) {
                    const glm::dvec3 point(mesh.points[i]);
                    if (glm::distance(point, place) > reach) continue;
                    std::vector<std::uint32_t>& own = cells[cellOf(point)];
                    if (std::ranges::any_of(own, [&](std::uint32_t other) {
                            return glm::distance(points_[other].place, point) < same;
                        }))
                        continue;
                    own.push_back(static_cast<std::uint32_t>(points_.size()));
                    points_.push_back({point, glm::dvec3(mesh.normals[i])});
                }
            }
}

void SurfacePatch::link(double within) {
    const CellOf cellOf{within};
    Cells cells;
    for (std::uint32_t i = 0; i < points_.size(); ++i) cells[cellOf(points_[i].place)].push_back(i);
    first_.assign(1, 0);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        visitAround(cells, cellOf(points_[i].place), [&](std::uint32_t other) {
            if (other != i && glm::distance(points_[i].place, points_[other].place) <= within)
                neighbours_.push_back(other);
        });
        first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    }
}

std::span<const std::uint32_t> SurfacePatch::neighbours(std::uint32_t point) const noexcept {
    return std::span(neighbours_).subspan(first_[point], first_[point + 1] - first_[point]);
}

std::optional<std::uint32_t> SurfacePatch::nearest(const glm::dvec3& place) const noexcept {
    const auto found = std::ranges::min_element(
        points_, {}, [&](const SurfacePoint& point) { return glm::distance(point.place, place); });
    if (found == points_.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - points_.begin());
}

} // namespace burin
