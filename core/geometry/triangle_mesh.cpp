// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_mesh.h"

#include <bit>
#include <cstring>
#include <unordered_map>

namespace burin {

namespace {

struct PointHash {
    std::size_t operator()(const glm::dvec3& p) const noexcept {
        std::uint64_t hash = 1469598103934665603ULL;
        for (int axis = 0; axis < 3; ++axis) {
            hash ^= std::bit_cast<std::uint64_t>(p[axis] + 0.0); // -0.0 and 0.0 are the same position
            hash *= 1099511628211ULL;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash);
    }
};

} // namespace

Box boundingBox(const TriangleMesh& mesh) {
    Box box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box.include(mesh.vertices[vertex]);
    return box;
}

double signedVolume(const TriangleMesh& mesh) {
    if (mesh.empty()) return 0.0;
    // Relative to a vertex of the mesh: a part far from the origin would lose digits otherwise.
    const glm::dvec3 origin = mesh.vertices[mesh.triangles.front()[0]];
    double six = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += glm::dot(mesh.vertices[a] - origin, glm::cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
    return six / 6.0;
}

double surfaceArea(const TriangleMesh& mesh) {
    double twice = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        twice += glm::length(glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
    return 0.5 * twice;
}

std::vector<std::uint32_t> firstAtSamePlace(const TriangleMesh& mesh) {
    constexpr std::uint32_t none = 0xFFFFFFFFU;
    const std::size_t size = std::bit_ceil(2 * mesh.vertices.size() + 1); // of an open hash table
    std::vector<std::uint32_t> table(size, none), first(mesh.vertices.size());
    for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex) {
        std::size_t place = PointHash{}(mesh.vertices[vertex]) & (size - 1);
        while (table[place] != none && mesh.vertices[table[place]] != mesh.vertices[vertex])
            place = (place + 1) & (size - 1);
        if (table[place] == none) table[place] = vertex;
        first[vertex] = table[place];
    }
    return first;
}

TriangleMesh weldIdenticalVertices(const TriangleMesh& mesh) {
    TriangleMesh welded;
    welded.triangles.reserve(mesh.triangles.size());
    std::unordered_map<glm::dvec3, std::uint32_t, PointHash> places;
    places.reserve(mesh.vertices.size());
    const auto place = [&](std::uint32_t vertex) {
        const glm::dvec3& point = mesh.vertices[vertex];
        const auto [entry, added] = places.try_emplace(point, static_cast<std::uint32_t>(welded.vertices.size()));
        if (added) welded.vertices.push_back(point);
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::array<std::uint32_t, 3> triangle{place(a), place(b), place(c)};
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            welded.triangles.push_back(triangle);
    }
    return welded;
}

std::size_t countOpenEdges(const TriangleMesh& mesh) {
    // Per undirected edge: uses in one direction in the high half, in the other in the low half.
    std::unordered_map<std::uint64_t, std::uint64_t> uses;
    uses.reserve(mesh.triangles.size() * 3 / 2);
    for (const auto& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t from = triangle[corner], to = triangle[(corner + 1) % 3];
            const bool forward = from < to;
            const std::uint64_t key = forward ? (from << 32) | to : (to << 32) | from;
            uses[key] += forward ? (1ULL << 32) : 1ULL;
        }
    std::size_t open = 0;
    for (const auto& [edge, count] : uses)
        if (count != ((1ULL << 32) | 1ULL)) ++open;
    return open;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    mesh.triangles.reserve(mesh.triangles.size() + other.triangles.size());
    for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

} // namespace burin
