// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/surface_normals.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {

namespace {

double cornerAngle(const Triangle& t, std::size_t corner) noexcept {
    const glm::dvec3 u = t[(corner + 1) % 3] - t[corner], v = t[(corner + 2) % 3] - t[corner];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

constexpr std::uint32_t none = SurfaceNormals::none;

using Corners = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t grain = 4096;

/// The triangles around each vertex, one list after the other, each in the order of the slots. A triangle that has a
/// vertex twice is in its list twice.
struct Fans {
    std::vector<std::uint32_t> begin; ///< per vertex, and one more
    std::vector<std::uint32_t> slots;

    /// Each core goes through all triangles and counts part of the vertices: the order does not depend on the number of
    /// cores.
    Fans(const Corners& corners, std::size_t vertexCount) : begin(vertexCount + 1) {
        constexpr std::size_t parts = 4;
        const auto shareOf = [&](std::size_t part, const auto& visit) {
            const auto first = static_cast<std::uint32_t>(vertexCount * part / parts),
                       end = static_cast<std::uint32_t>(vertexCount * (part + 1) / parts);
            for (std::uint32_t slot = 0; slot < corners.size(); ++slot)
                for (const std::uint32_t vertex : corners[slot])
                    if (vertex - first < end - first) visit(vertex, slot);
        };
        parallelFor(std::size_t{0}, parts, [&](std::size_t part) {
            shareOf(part, [&](std::uint32_t vertex, std::uint32_t) { ++begin[vertex + 1]; });
        });
        for (std::size_t i = 0; i < vertexCount; ++i) begin[i + 1] += begin[i];
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        slots.resize(begin.back());
        parallelFor(std::size_t{0}, parts, [&](std::size_t part) {
            shareOf(part, [&](std::uint32_t vertex, std::uint32_t slot) { slots[next[vertex]++] = slot; });
        });
    }

    std::span<const std::uint32_t> around(std::size_t vertex) const noexcept {
        return std::span(slots).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
    }
};

/// A corner of a triangle at the current vertex: edges lead from there to `next` and from `last` to there.
struct FanCorner {
    std::uint32_t slot, next, last;
    std::size_t corner;
};

void cornersAround(const Corners& corners, std::span<const std::uint32_t> fan, std::uint32_t vertex,
                   std::vector<FanCorner>& found) {
    found.clear();
    for (const std::uint32_t slot : fan)
        for (std::size_t i = 0; i < 3; ++i)
            if (corners[slot][i] == vertex)
                found.push_back({slot, corners[slot][(i + 1) % 3], corners[slot][(i + 2) % 3], i});
}

/// The triangle beyond the edge from the vertex to another one, which it has in the opposite direction; none unless
/// exactly two triangles share the edge.
std::uint32_t beyond(const std::vector<FanCorner>& around, std::uint32_t to) noexcept {
    std::uint32_t found = none;
    int sharing = 0; // in either direction
    for (const FanCorner& other : around) {
        if (other.last == to) found = other.slot;
        sharing += (other.last == to ? 1 : 0) + (other.next == to ? 1 : 0);
    }
    return sharing == 2 ? found : none;
}

} // namespace

bool isThin(const Triangle& triangle, double thin) noexcept {
    double longest = 0.0; // squared
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = triangle[(i + 1) % 3] - triangle[i];
        longest = std::max(longest, glm::dot(edge, edge));
    }
    return glm::length(areaNormal(triangle)) <= thin * std::sqrt(longest);
}

double surroundingAngle(const Triangle& triangle, TriangleFeature feature) noexcept {
    switch (feature) {
    case TriangleFeature::face:
        return 2.0 * std::numbers::pi;
    case TriangleFeature::edgeAB:
    case TriangleFeature::edgeBC:
    case TriangleFeature::edgeCA:
        return std::numbers::pi;
    default:
        return cornerAngle(triangle, static_cast<std::size_t>(feature) - 4);
    }
}

SurfaceNormals::SurfaceNormals(const TriangleMesh& mesh, std::span<const std::uint32_t> merged,
                               std::span<const std::uint32_t> order, double thin)
    : thin_(thin)
    , corners_(order.size())
    , neighbours_(order.size(), {none, none, none})
    , vertexNormals_(mesh.vertices.size(), glm::dvec3(0.0)) {
    std::vector<glm::dvec3> normals(order.size()); // zero for a triangle that is thin or without area
    const auto triangleAt = [&](std::size_t slot) {
        const auto& [a, b, c] = corners_[slot];
        return Triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    };
    parallelIntervals(std::size_t{0}, order.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t slot = from; slot < to; ++slot) {
            const auto& [a, b, c] = mesh.triangles[order[slot]];
            corners_[slot] = {merged[a], merged[b], merged[c]};
            const Triangle triangle = triangleAt(slot);
            if (!isThin(triangle, thin_)) normals[slot] = unitNormal(triangle);
        }
    });
    const Fans fans(corners_, mesh.vertices.size());
    // A triangle's edges belong to the vertices at which they begin, so that no two threads write to the same element.
    parallelIntervals(std::size_t{0}, mesh.vertices.size(), grain, [&](std::size_t first, std::size_t end) {
        std::vector<FanCorner> around;
        for (std::size_t vertex = first; vertex < end; ++vertex) {
            cornersAround(corners_, fans.around(vertex), static_cast<std::uint32_t>(vertex), around);
            for (const FanCorner& own : around) {
                const std::uint32_t other = beyond(around, own.next);
                if (other != none && normals[own.slot] != glm::dvec3(0.0) && normals[other] != glm::dvec3(0.0))
                    neighbours_[own.slot][own.corner] = other;
            }
        }
    });
    parallelIntervals(std::size_t{0}, mesh.vertices.size(), grain, [&](std::size_t first, std::size_t end) {
        for (std::size_t vertex = first; vertex < end; ++vertex) {
            bool doubtful = false;
            for (const std::uint32_t slot : fans.around(vertex))
                for (std::size_t i = 0; i < 3; ++i) {
                    if (corners_[slot][i] != vertex) continue;
                    doubtful = doubtful || neighbours_[slot][i] == none || neighbours_[slot][(i + 2) % 3] == none;
                    vertexNormals_[vertex] += cornerAngle(triangleAt(slot), i) * normals[slot];
                }
            if (doubtful) vertexNormals_[vertex] = glm::dvec3(0.0);
        }
    });
}

std::optional<glm::dvec3> SurfaceNormals::at(std::span<const Triangle> triangles, std::size_t slot,
                                             TriangleFeature feature) const noexcept {
    const auto part = static_cast<std::size_t>(feature);
    if (isThin(triangles[slot], thin_)) return std::nullopt;
    const glm::dvec3 own = unitNormal(triangles[slot]);
    if (own == glm::dvec3(0.0)) return std::nullopt;
    if (feature == TriangleFeature::face) return own;
    if (part < 4) {
        const std::uint32_t beyond = neighbours_[slot][part - 1];
        if (beyond == none) return std::nullopt;
        return own + unitNormal(triangles[beyond]);
    }
    const glm::dvec3 normal = vertexNormals_[corners_[slot][part - 4]];
    if (normal == glm::dvec3(0.0)) return std::nullopt;
    return normal;
}

} // namespace burin
