// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/surface_normals.h"

#include <cmath>
#include <numbers>

namespace burin {

namespace {

double cornerAngle(const Triangle& t, std::size_t corner) noexcept {
    const glm::dvec3 u = t[(corner + 1) % 3] - t[corner], v = t[(corner + 2) % 3] - t[corner];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

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
    const std::vector<std::uint32_t> merged = firstAtSamePlace(mesh);
    corners_.reserve(order.size());
    for (const std::uint32_t triangle : order) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        corners_.push_back({merged[a], merged[b], merged[c]});
    }
    const auto corner = [&](std::size_t slot, std::size_t i) { return mesh.vertices[corners_[slot][i]]; };
    const auto triangleAt = [&](std::size_t slot) {
        return Triangle{corner(slot, 0), corner(slot, 1), corner(slot, 2)};
    };

    const Fans fans(corners_, mesh.vertices.size());
    std::vector<bool> doubtful(mesh.vertices.size(), false);
    for (std::uint32_t slot = 0; slot < corners_.size(); ++slot) {
        const Triangle triangle = triangleAt(slot);
        const glm::dvec3 normal = unitNormal(triangle);
        const bool flat = normal == glm::dvec3(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners_[slot][i], to = corners_[slot][(i + 1) % 3];
            vertexNormals_[from] += cornerAngle(triangle, i) * normal;

            std::uint32_t beyond = none;
            std::size_t sharing = 0; // triangles with this edge, whichever way round
            for (std::uint32_t at = fans.begin[from]; at < fans.begin[from + 1]; ++at) {
                const auto& other = corners_[fans.slots[at]];
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t first = other[k], second = other[(k + 1) % 3];
                    if (first == to && second == from) beyond = fans.slots[at];
                    if ((first == to && second == from) || (first == from && second == to)) ++sharing;
                }
            }
            const bool ordinary =
                !flat && sharing == 2 && beyond != none && unitNormal(triangleAt(beyond)) != glm::dvec3(0.0);
            if (ordinary)
                neighbours_[slot][i] = beyond;
            else
                doubtful[from] = doubtful[to] = true;
        }
    }
    for (std::size_t vertex = 0; vertex < doubtful.size(); ++vertex)
        if (doubtful[vertex]) vertexNormals_[vertex] = glm::dvec3(0.0);
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
