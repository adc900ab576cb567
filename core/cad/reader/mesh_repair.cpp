// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/mesh_repair.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace burin {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Two of the triangles at one undirected edge, and the number of all.
struct EdgeUse {
    std::uint32_t first = none, second = none, count = 0;
};
using EdgeUses = std::unordered_map<std::uint64_t, EdgeUse>;

std::uint64_t edgeKey(std::uint64_t a, std::uint64_t b) {
    return a < b ? (a << 32) | b : (b << 32) | a;
}

EdgeUses collectEdges(const TriangleMesh& mesh) {
    EdgeUses uses;
    uses.reserve(mesh.triangles.size() * 3 / 2);
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto& corners = mesh.triangles[triangle];
            EdgeUse& use = uses[edgeKey(corners[corner], corners[(corner + 1) % 3])];
            (use.count == 0 ? use.first : use.second) = triangle;
            ++use.count;
        }
    return uses;
}

/// Neighbour of a triangle across each of its edges; none if the edge is not shared by exactly two triangles.
std::vector<std::array<std::uint32_t, 3>> neighbours(const TriangleMesh& mesh, const EdgeUses& uses) {
    std::vector<std::array<std::uint32_t, 3>> result(mesh.triangles.size(), {none, none, none});
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto& corners = mesh.triangles[triangle];
            const EdgeUse& use = uses.at(edgeKey(corners[corner], corners[(corner + 1) % 3]));
            if (use.count == 2 && use.first != use.second)
                result[triangle][corner] = use.first == triangle ? use.second : use.first;
        }
    return result;
}

/// Calls `visit(from, corner, to)` for every step from a triangle across an edge to one that was not reached before,
/// and `start(triangle)` for the first triangle of each piece.
template <class Start, class Visit>
void walkPieces(const std::vector<std::array<std::uint32_t, 3>>& across, Start start, Visit visit) {
    std::vector<bool> reached(across.size(), false);
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < across.size(); ++first) {
        if (reached[first]) continue;
        reached[first] = true;
        start(first);
        open.push_back(first);
        while (!open.empty()) {
            const std::uint32_t from = open.back();
            open.pop_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t to = across[from][corner];
                if (to == none || reached[to]) continue;
                reached[to] = true;
                visit(from, corner, to);
                open.push_back(to);
            }
        }
    }
}

bool runsAlong(const std::array<std::uint32_t, 3>& triangle, std::uint32_t from, std::uint32_t to) {
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (triangle[corner] == from && triangle[(corner + 1) % 3] == to) return true;
    return false;
}

} // namespace

MeshConnection separatePieces(TriangleMesh& mesh) {
    const EdgeUses uses = collectEdges(mesh);
    MeshConnection connection;
    connection.edges = uses.size();
    for (const auto& [edge, use] : uses)
        if (use.count == 1) ++connection.boundaryEdges;

    std::vector<std::size_t> piece(mesh.triangles.size(), 0);
    walkPieces(
        neighbours(mesh, uses), [&](std::uint32_t first) { piece[first] = connection.pieces++; },
        [&](std::uint32_t from, std::size_t, std::uint32_t to) { piece[to] = piece[from]; });

    // A vertex stays with the first piece that uses it; every other piece gets a copy.
    std::vector<std::size_t> owner(mesh.vertices.size(), connection.pieces);
    std::unordered_map<std::uint64_t, std::uint32_t> copies;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        for (std::uint32_t& vertex : mesh.triangles[triangle]) {
            if (owner[vertex] == connection.pieces) owner[vertex] = piece[triangle];
            if (owner[vertex] == piece[triangle]) continue;
            const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto [copy, added] = copies.try_emplace((std::uint64_t{vertex} << 32) | piece[triangle], next);
            if (added) {
                mesh.vertices.push_back(glm::dvec3(mesh.vertices[vertex]));
                owner.push_back(piece[triangle]);
            }
            vertex = copy->second;
        }
    return connection;
}

std::size_t orientConsistently(TriangleMesh& mesh) {
    std::vector<bool> turned(mesh.triangles.size(), false);
    std::vector<std::vector<std::uint32_t>> pieces;
    walkPieces(
        neighbours(mesh, collectEdges(mesh)), [&](std::uint32_t first) { pieces.push_back({first}); },
        [&](std::uint32_t from, std::size_t corner, std::uint32_t to) {
            const auto& corners = mesh.triangles[from];
            const bool same = runsAlong(mesh.triangles[to], corners[corner], corners[(corner + 1) % 3]);
            turned[to] = turned[from] != same;
            pieces.back().push_back(to);
        });
    // The larger part of a piece is most likely correct, so the smaller one is turned.
    for (const std::vector<std::uint32_t>& piece : pieces) {
        const auto count = std::count_if(piece.begin(), piece.end(), [&](std::uint32_t t) { return turned[t]; });
        if (2 * static_cast<std::size_t>(count) > piece.size())
            for (const std::uint32_t triangle : piece) turned[triangle] = !turned[triangle];
    }
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        if (turned[triangle]) std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
    if (signedVolume(mesh) < 0.0)
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
            turned[triangle] = !turned[triangle];
        }
    return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
}

} // namespace burin
