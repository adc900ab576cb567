// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/open_mesh.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace burin {

namespace {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// An edge that an odd number of triangles share, in the direction that more of them take.
struct OpenEdge {
    std::uint32_t from = 0, to = 0;
};

std::vector<OpenEdge> openEdges(const TriangleMesh& mesh) {
    struct Use {
        std::uint32_t low, high;
        bool rises;
    };
    std::vector<Use> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            uses.push_back({std::min(from, to), std::max(from, to), from < to});
    const auto key = [](const Use& use) { return std::uint64_t{use.low} << 32 | use.high; };
    std::ranges::sort(uses, {}, key);
    std::vector<OpenEdge> open;
    for (auto first = uses.begin(); first != uses.end();) {
        const auto end = std::find_if(first, uses.end(), [&](const Use& use) { return key(use) != key(*first); });
        if ((end - first) % 2 != 0) {
            const auto rising = std::count_if(first, end, [](const Use& use) { return use.rises; });
            open.push_back(2 * rising > end - first ? OpenEdge{first->low, first->high}
                                                    : OpenEdge{first->high, first->low});
        }
        first = end;
    }
    return open;
}

/// Points in a grid of cells, for finding one near another.
class NearbyPlaces {
public:
    explicit NearbyPlaces(double distance) : distance_(distance) {}
    /// The first earlier point within the distance, or this one, which is then added.
    std::uint32_t findOrAdd(std::uint32_t index, const glm::dvec3& place) {
        const Cell centre = cellOf(place);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto found = cells_.find({centre[0] + dx, centre[1] + dy, centre[2] + dz});
                    if (found == cells_.end()) continue;
                    for (const auto& [other, at] : found->second)
                        if (glm::distance(at, place) <= distance_) return other;
                }
        cells_[centre].emplace_back(index, place);
        return index;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const noexcept {
            std::uint64_t hash = 0;
            for (const std::int64_t part : cell) {
                hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
                hash ^= hash >> 32;
            }
            return hash;
        }
    };
    Cell cellOf(const glm::dvec3& place) const noexcept {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(place[axis] / distance_));
        return cell;
    }
    double distance_;
    std::unordered_map<Cell, std::vector<std::pair<std::uint32_t, glm::dvec3>>, CellHash> cells_;
};

/// Decomposes open edges into loops that pass no vertex twice. At each vertex an even number of them meet.
class Loops {
public:
    explicit Loops(std::span<const OpenEdge> edges) : edges_(edges), used_(edges.size()) {
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            atVertex_[edges[i].from].push_back(i);
            atVertex_[edges[i].to].push_back(i);
        }
    }
    /// Calls visit(edges of the loop).
    template <class Visit>
    void forEach(Visit&& visit) {
        for (std::uint32_t start = 0; start < edges_.size(); ++start)
            while (!used_[start]) walk(edges_[start].from, visit);
    }

private:
    struct Step {
        OpenEdge edge;
        std::uint32_t from = 0; ///< the end of the edge from which the walk came
    };

    template <class Visit>
    void walk(std::uint32_t vertex, Visit& visit) {
        std::vector<Step> way;
        std::unordered_map<std::uint32_t, std::size_t> passed; ///< position on the way
        while (const OpenEdge* const edge = next(vertex)) {
            passed[vertex] = way.size();
            way.push_back({*edge, vertex});
            vertex = edge->from == vertex ? edge->to : edge->from;
            const auto closed = passed.find(vertex);
            if (closed == passed.end()) continue;
            std::vector<OpenEdge> loop;
            const std::size_t first = closed->second;
            for (std::size_t i = first; i < way.size(); ++i) {
                loop.push_back(way[i].edge);
                passed.erase(way[i].from);
            }
            way.resize(first);
            visit(std::span<const OpenEdge>(loop));
        }
    }
    /// An unused edge at a vertex, preferably one that leaves it.
    const OpenEdge* next(std::uint32_t vertex) {
        std::vector<std::uint32_t>& here = atVertex_[vertex];
        std::erase_if(here, [&](std::uint32_t edge) { return used_[edge]; });
        if (here.empty()) return nullptr;
        const auto leaving = std::ranges::find(here, vertex, [&](std::uint32_t edge) { return edges_[edge].from; });
        const std::uint32_t edge = leaving != here.end() ? *leaving : here.front();
        used_[edge] = true;
        return &edges_[edge];
    }

    std::span<const OpenEdge> edges_;
    std::vector<bool> used_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> atVertex_;
};

} // namespace

OpenMesh::OpenMesh(const TriangleMesh& mesh, double tolerance) : closed_(weldIdenticalVertices(mesh)) {
    dropDuplicates();
    mergeRims(tolerance);
    addCaps();
}

void OpenMesh::dropDuplicates() {
    // With the least index first, two triangles are equal only if they have the same orientation.
    std::vector<TriangleIndices> canonical = closed_.triangles;
    for (TriangleIndices& triangle : canonical) std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    std::vector<std::uint32_t> order(canonical.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::uint32_t t) { return std::pair(canonical[t], t); });
    std::vector<bool> again(canonical.size());
    for (std::size_t i = 1; i < order.size(); ++i) again[order[i]] = canonical[order[i]] == canonical[order[i - 1]];
    std::size_t kept = 0;
    for (std::size_t t = 0; t < again.size(); ++t)
        if (!again[t]) closed_.triangles[kept++] = closed_.triangles[t];
    duplicates_ = closed_.triangles.size() - kept;
    closed_.triangles.resize(kept);
}

void OpenMesh::mergeRims(double tolerance) {
    std::map<std::uint32_t, std::uint32_t> merged;
    for (const auto& [from, to] : openEdges(closed_)) {
        merged.emplace(from, from);
        merged.emplace(to, to);
    }
    NearbyPlaces places(tolerance);
    for (auto& [vertex, goal] : merged) goal = places.findOrAdd(vertex, closed_.vertices[vertex]);
    std::size_t kept = 0;
    for (TriangleIndices triangle : closed_.triangles) {
        for (std::uint32_t& vertex : triangle)
            if (const auto found = merged.find(vertex); found != merged.end()) vertex = found->second;
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            closed_.triangles[kept++] = triangle;
    }
    closed_.triangles.resize(kept);
}

void OpenMesh::addCaps() {
    firstCap_ = closed_.triangles.size();
    const std::vector<OpenEdge> rims = openEdges(closed_);
    Loops(rims).forEach([&](std::span<const OpenEdge> rim) {
        glm::dvec3 sum(0.0);
        for (const auto& [from, to] : rim) sum += 0.5 * (closed_.vertices[from] + closed_.vertices[to]);
        const auto middle = static_cast<std::uint32_t>(closed_.vertices.size());
        closed_.vertices.push_back(sum / static_cast<double>(rim.size()));
        for (const auto& [from, to] : rim) closed_.triangles.push_back({to, from, middle});
        ++holes_;
    });
}

double OpenMesh::windingOfCaps(const glm::dvec3& place) const noexcept {
    return windingNumber(closed_, firstCap_, place);
}

double windingNumber(const TriangleMesh& mesh, std::size_t firstTriangle, const glm::dvec3& place) noexcept {
    double halfAngles = 0.0;
    for (std::size_t t = firstTriangle; t < mesh.triangles.size(); ++t) {
        const auto& [ia, ib, ic] = mesh.triangles[t];
        const glm::dvec3 a = mesh.vertices[ia] - place, b = mesh.vertices[ib] - place, c = mesh.vertices[ic] - place;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        halfAngles += std::atan2(glm::dot(a, glm::cross(b, c)),
                                 la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return halfAngles / (2.0 * pi);
}

} // namespace burin
