// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin::test {

/// Distance to a segment; slow and obvious.
inline double segmentDistance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 way = b - a;
    const double square = glm::dot(way, way);
    const double part = square > 0.0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + part * way);
}

/// Nearest point of a triangle, by its inside and its three edges.
inline double triangleDistance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 twice = glm::cross(b - a, c - a);
    if (twice != glm::dvec3(0.0)) {
        const glm::dvec3 normal = glm::normalize(twice), foot = p - glm::dot(p - a, normal) * normal;
        if (glm::dot(glm::cross(b - a, foot - a), normal) >= 0.0 &&
            glm::dot(glm::cross(c - b, foot - b), normal) >= 0.0 &&
            glm::dot(glm::cross(a - c, foot - c), normal) >= 0.0)
            return glm::distance(p, foot);
    }
    return std::min({segmentDistance(p, a, b), segmentDistance(p, b, c), segmentDistance(p, c, a)});
}

/// Computes the distances to all triangles near a point, found by the square columns that contain them.
class PartOracle {
public:
    /// @param radius mm, of a ball end mill whose shank is as wide
    PartOracle(const TriangleMesh& mesh, double radius, double columnWidth)
        : mesh_(mesh), radius_(radius), column_(columnWidth) {
        box_ = boundingBox(mesh);
        columnsX_ = countOf(box_.size().x);
        columnsY_ = countOf(box_.size().y);
        columns_.resize(static_cast<std::size_t>(columnsX_ * columnsY_));
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            Box box;
            for (const glm::dvec3& corner : corners(i)) box.include(corner);
            boxes_.push_back(box);
            forEachColumn(box.low, box.high, [&](std::vector<std::uint32_t>& standing) { standing.push_back(i); });
        }
    }

    /// The least distance of the ball, and of points of the shank's axis half a millimetre apart, from the part; at
    /// most `most`.
    double clearance(const glm::dvec3& tip, double most) const {
        double least = most;
        for (int i = 0; i <= 38; ++i) {
            const glm::dvec3 place = tip + glm::dvec3(0.0, 0.0, radius_ + 0.5 * i);
            if (place.z - radius_ > box_.high.z + least) break; // above everything
            if (isInside(place)) return std::min(least, -radius_ - distanceTo(place, 1e9));
            least = std::min(least, distanceTo(place, least + radius_) - radius_);
        }
        return least;
    }

private:
    std::array<glm::dvec3, 3> corners(std::uint32_t i) const {
        const auto& [a, b, c] = mesh_.triangles[i];
        return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
    }
    int countOf(double length) const { return static_cast<int>(length / column_) + 1; }
    /// Calls `visit(triangles)` for the columns that a box overlaps.
    template <class Visit>
    void forEachColumn(const glm::dvec3& low, const glm::dvec3& high, const Visit& visit) const {
        const auto at = [&](double along, int count) {
            return static_cast<int>(std::clamp(std::floor(along / column_), 0.0, count - 1.0));
        };
        for (int y = at(low.y - box_.low.y, columnsY_); y <= at(high.y - box_.low.y, columnsY_); ++y)
            for (int x = at(low.x - box_.low.x, columnsX_); x <= at(high.x - box_.low.x, columnsX_); ++x)
                visit(columns_[static_cast<std::size_t>(y * columnsX_ + x)]);
    }
    /// The nearest columns first: after them few triangles of the others have to be examined.
    double distanceTo(const glm::dvec3& place, double within) const {
        double nearest = within;
        for (const double reach : {column_, within}) {
            const glm::dvec3 around(std::min(reach, nearest));
            forEachColumn(place - around, place + around, [&](const std::vector<std::uint32_t>& triangles) {
                for (const std::uint32_t i : triangles) {
                    const glm::dvec3 gap =
                        glm::max(glm::max(boxes_[i].low - place, place - boxes_[i].high), glm::dvec3(0.0));
                    if (glm::dot(gap, gap) >= nearest * nearest) continue;
                    const auto [a, b, c] = corners(i);
                    nearest = std::min(nearest, triangleDistance(place, a, b, c));
                }
            });
        }
        return nearest;
    }
    /// By the parity of the intersections of a ray upwards; the ray is offset by an insignificant distance, so that it
    /// misses edges and corners.
    bool isInside(const glm::dvec3& at) const {
        const glm::dvec3 place = at + glm::dvec3(1.37e-7, 2.11e-7, 0.0);
        if (!box_.contains(place)) return false;
        bool inside = false;
        forEachColumn(place, place, [&](const std::vector<std::uint32_t>& triangles) {
            for (const std::uint32_t i : triangles) {
                const auto [a, b, c] = corners(i);
                const auto side = [&](const glm::dvec3& p, const glm::dvec3& q) {
                    return (q.x - p.x) * (place.y - p.y) - (q.y - p.y) * (place.x - p.x);
                };
                const double ab = side(a, b), bc = side(b, c), ca = side(c, a), all = ab + bc + ca;
                const bool within = (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
                if (within && (bc * a.z + ca * b.z + ab * c.z) / all > place.z) inside = !inside;
            }
        });
        return inside;
    }

    const TriangleMesh& mesh_;
    double radius_, column_;
    Box box_;
    int columnsX_ = 0, columnsY_ = 0;
    std::vector<Box> boxes_; ///< of the triangles
    mutable std::vector<std::vector<std::uint32_t>> columns_;
};

} // namespace burin::test
