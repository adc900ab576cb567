// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/surface_normals.h"

#include "core/base/parallel.h"

#include <cmath>
#include <numbers>

namespace burin {

namespace {

double cornerAngle(const Triangle& t, std::size_t corner) noexcept {
    const glm::dvec3 u = t[(corner + 1) % 3] - t[corner], v = t[(corner + 2) % 3] - t[corner];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

constexpr std::uint32_t none = SurfaceNormals::none;

/// The triangles around each vertex, one list after the other.
struct Fans {
    std::vector<std::uint32_t> begin; ///< per vertex, and one more
    std::vector<std::uint32_t> slots;

    Fans(const std::vector<std::array<std::uint32_t, 3>>& corners, std::size_t vertexCount) : begin(vertexCount + 1) {
        for (const auto& triangle : corners)
            for (const std::uint32_t vertex : triangle) ++begin[vertex + 1];
        for (std::size_t i = 0; i < vertexCount; ++i) begin[i + 1] += begin[i];
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        slots.resize(begin.back());
        for (std::uint32_t slot = 0; slot < corners.size(); ++slot)
            for (const std::uint32_t vertex : corners[slot]) slots[next[vertex]++] = slot;
    }

    std::span<const std::uint32_t> around(std::size_t vertex) const noexcept {
        return std::span(slots).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
    }

    /// The triangle that has an edge the other way round; none unless exactly two triangles share the edge.
    std::uint32_t beyond(const std::vector<std::array<std::uint32_t, 3>>& corners, std::uint32_t from,
                         std::uint32_t to) const noexcept {
        std::uint32_t found = none;
        std::size_t sharing = 0; // whichever way round
        for (const std::uint32_t slot : around(from))
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t first = corners[slot][k], second = corners[slot][(k + 1) % 3];
                if (first == to && second == from) found = slot;
                if ((first == to && second == from) || (first == from && second == to)) ++sharing;
            }
        return sharing == 2 ? found : none;
    }
};

} // namespace

glm::dvec3 unitNormal(const Triangle& triangle) noexcept {
    const glm::dvec3 normal = areaNormal(triangle);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
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

SurfaceNormals::SurfaceNormals(const TriangleMesh& mesh, std::span<const std::uint32_t> order)
    : neighbours_(order.size(), {none, none, none}), vertexNormals_(mesh.vertices.size(), glm::dvec3(0.0)) {
    constexpr std::size_t grain = 4096;
    std::vector<std::uint8_t> doubtful(mesh.vertices.size(), 0);
    const std::vector<std::uint32_t> merged = firstAtSamePlace(mesh);
    corners_.reserve(order.size());
    for (const std::uint32_t triangle : order) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        corners_.push_back({merged[a], merged[b], merged[c]});
    }
    const auto triangleAt = [&](std::size_t slot) {
        const auto& [a, b, c] = corners_[slot];
        return Triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    };
    const Fans fans(corners_, mesh.vertices.size());
    std::vector<glm::dvec3> normals(corners_.size()); // zero: a triangle without area
    parallelStretches(std::size_t{0}, corners_.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t slot = from; slot < to; ++slot) normals[slot] = unitNormal(triangleAt(slot));
    });
    const auto ordinary = [&](std::size_t slot, std::uint32_t beyond) {
        return normals[slot] != glm::dvec3(0.0) && beyond != none && normals[beyond] != glm::dvec3(0.0);
    };
    parallelStretches(std::size_t{0}, corners_.size(), grain, [&](std::size_t first, std::size_t end) {
        for (std::size_t slot = first; slot < end; ++slot)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t beyond = fans.beyond(corners_, corners_[slot][i], corners_[slot][(i + 1) % 3]);
                if (ordinary(slot, beyond)) neighbours_[slot][i] = beyond;
            }
    });
    parallelStretches(std::size_t{0}, vertexNormals_.size(), grain, [&](std::size_t first, std::size_t end) {
        for (std::size_t vertex = first; vertex < end; ++vertex)
            for (const std::uint32_t slot : fans.around(vertex))
                for (std::size_t i = 0; i < 3; ++i) {
                    if (corners_[slot][i] != vertex) continue;
                    if (neighbours_[slot][i] == none || neighbours_[slot][(i + 2) % 3] == none) doubtful[vertex] = 1;
                    vertexNormals_[vertex] += cornerAngle(triangleAt(slot), i) * normals[slot];
                }
    });
    for (std::size_t vertex = 0; vertex < doubtful.size(); ++vertex)
        if (doubtful[vertex] != 0) vertexNormals_[vertex] = glm::dvec3(0.0);
}

std::optional<glm::dvec3> SurfaceNormals::at(std::span<const Triangle> triangles, std::size_t slot,
                                             TriangleFeature feature) const noexcept {
    const auto part = static_cast<std::size_t>(feature);
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
