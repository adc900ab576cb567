// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/upright_holes.h"

#include "core/base/units.h"
#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace burin {

namespace {

constexpr double uprightWithin = 0.002;          // of the z of a unit normal
constexpr double roundWithin = 0.01;             // mm from the circle
constexpr double leastCosine = 0.766;            // of a bend of 40 degrees
constexpr double largestGap = 41.0 * pi / 180.0; // rad between neighbours round the axis
constexpr double sameAxis = 0.01;                // mm
constexpr double least = 1e-9;                   // mm² of a triangle that has a normal

/// A triangle of an upright wall.
struct WallFacet {
    Triangle triangle{};
    glm::dvec2 normal{0.0};                 ///< unit, out of the solid
    std::array<std::uint32_t, 3> corners{}; ///< equal numbers for equal positions
};

std::vector<WallFacet> wallFacets(std::span<const Triangle> triangles) {
    TriangleMesh walls;
    for (const Triangle& triangle : triangles) {
        const glm::dvec3 normal = areaNormal(triangle);
        const double length = glm::length(normal);
        if (!(length > least) || std::abs(normal.z) > uprightWithin * length) continue;
        const auto first = static_cast<std::uint32_t>(walls.vertices.size());
        walls.vertices.insert(walls.vertices.end(), triangle.begin(), triangle.end());
        walls.triangles.push_back({first, first + 1, first + 2});
    }
    walls = weldIdenticalVertices(walls);
    std::vector<WallFacet> facets;
    for (const auto& corners : walls.triangles) {
        const Triangle triangle{walls.vertices[corners[0]], walls.vertices[corners[1]], walls.vertices[corners[2]]};
        facets.push_back({triangle, glm::normalize(glm::dvec2(areaNormal(triangle))), corners});
    }
    return facets;
}

/// Sets of facets that are connected without a sharp bend.
class Walls {
public:
    explicit Walls(const std::vector<WallFacet>& facets) : parent_(facets.size()) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        std::unordered_map<std::uint64_t, std::size_t> sides;
        for (std::size_t i = 0; i < facets.size(); ++i)
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint64_t from = facets[i].corners[side], to = facets[i].corners[(side + 1) % 3];
                sides.emplace(from << 32 | to, i);
                const auto beside = sides.find(to << 32 | from);
                if (beside != sides.end() && glm::dot(facets[i].normal, facets[beside->second].normal) > leastCosine)
                    parent_[rootOf(i)] = rootOf(beside->second);
            }
    }
    std::vector<std::vector<std::size_t>> sets() {
        std::unordered_map<std::size_t, std::size_t> places;
        std::vector<std::vector<std::size_t>> sets;
        for (std::size_t i = 0; i < parent_.size(); ++i) {
            const auto [place, added] = places.try_emplace(rootOf(i), sets.size());
            if (added) sets.emplace_back();
            sets[place->second].push_back(i);
        }
        return sets;
    }

private:
    std::size_t rootOf(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    std::vector<std::size_t> parent_;
};

/// The circle with the least sum of squared powers of the points (Kåsa), radius in z; empty if they are collinear.
std::optional<glm::dvec3> circleThrough(const std::vector<glm::dvec2>& places) {
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& place : places) middle += place / static_cast<double>(places.size());
    double xx = 0.0, xy = 0.0, yy = 0.0, xr = 0.0, yr = 0.0, rr = 0.0;
    for (const glm::dvec2& place : places) {
        const glm::dvec2 p = place - middle;
        const double square = glm::dot(p, p);
        xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
        xr += p.x * square, yr += p.y * square, rr += square;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-12 * rr * rr)) return {};
    const glm::dvec2 centre = 0.5 / determinant * glm::dvec2(xr * yy - yr * xy, yr * xx - xr * xy);
    return glm::dvec3(middle + centre, std::sqrt(rr / static_cast<double>(places.size()) + glm::dot(centre, centre)));
}

/// The greatest angle about the centre without a point, rad.
double largestGapOf(const std::vector<glm::dvec2>& places, const glm::dvec2& centre) {
    std::vector<double> angles;
    for (const glm::dvec2& place : places) angles.push_back(std::atan2(place.y - centre.y, place.x - centre.x));
    std::ranges::sort(angles);
    double gap = angles.front() + 2.0 * pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
    return gap;
}

/// @param stud whether it has to be a stud, and not a hole
std::optional<UprightHole> holeOf(const std::vector<WallFacet>& facets, const std::vector<std::size_t>& wall,
                                  bool stud) {
    std::vector<glm::dvec2> places;
    for (const std::size_t i : wall)
        for (const glm::dvec3& corner : facets[i].triangle) places.emplace_back(corner);
    const std::optional<glm::dvec3> circle = circleThrough(places);
    if (!circle) return {};
    UprightHole hole{glm::dvec2(*circle),
                     circle->z,
                     circle->z,
                     -std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity(),
                     stud};
    for (const glm::dvec2& place : places)
        if (std::abs(glm::distance(place, hole.centre) - hole.radius) > roundWithin) return {};
    if (largestGapOf(places, hole.centre) > largestGap) return {};
    for (const std::size_t i : wall) {
        const double inwards = glm::dot(hole.centre - glm::dvec2(facets[i].triangle[0]), facets[i].normal);
        if ((inwards <= 0.0) != stud) return {};
        hole.clearRadius = std::min(hole.clearRadius, std::abs(inwards));
        for (const glm::dvec3& corner : facets[i].triangle) {
            hole.top = std::max(hole.top, corner.z);
            hole.bottom = std::min(hole.bottom, corner.z);
        }
    }
    return hole;
}

bool isSame(const UprightHole& one, const UprightHole& other) {
    return glm::distance(one.centre, other.centre) < sameAxis && std::abs(one.radius - other.radius) < sameAxis;
}

std::vector<UprightHole> roundWalls(std::span<const Triangle> triangles, bool studs) {
    const std::vector<WallFacet> facets = wallFacets(triangles);
    std::vector<UprightHole> found, holes;
    for (const std::vector<std::size_t>& wall : Walls(facets).sets())
        if (const std::optional<UprightHole> hole = holeOf(facets, wall, studs)) found.push_back(*hole);
    std::ranges::sort(found, [](const UprightHole& a, const UprightHole& b) {
        return a.centre.x != b.centre.x ? a.centre.x < b.centre.x : a.centre.y < b.centre.y;
    });
    for (const UprightHole& hole : found) {
        // Holes with one axis are adjacent, because they are sorted.
        auto same = holes.end();
        for (auto one = holes.end(); one != holes.begin() && hole.centre.x - std::prev(one)->centre.x < sameAxis; --one)
            if (isSame(*std::prev(one), hole)) same = std::prev(one);
        if (same == holes.end()) {
            holes.push_back(hole);
            continue;
        }
        same->top = std::max(same->top, hole.top);
        same->bottom = std::min(same->bottom, hole.bottom);
        same->clearRadius = std::min(same->clearRadius, hole.clearRadius);
    }
    return holes;
}

} // namespace

std::vector<UprightHole> uprightHoles(std::span<const Triangle> triangles) {
    return roundWalls(triangles, false);
}

std::vector<UprightHole> uprightStuds(std::span<const Triangle> triangles) {
    return roundWalls(triangles, true);
}

const UprightHole* holeAround(std::span<const UprightHole> holes, const glm::dvec2& place) noexcept {
    const UprightHole* around = nullptr;
    for (const UprightHole& hole : holes)
        if (glm::distance(hole.centre, place) < hole.radius && (!around || hole.radius < around->radius))
            around = &hole;
    return around;
}

} // namespace burin
