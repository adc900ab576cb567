// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/shaded_mesh.h"

#include "core/geometry/triangle_ray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace burin {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using PointColour = std::array<std::uint8_t, 4>; ///< as ShadedMesh::colours

/// The triangle corners that meet in each vertex, without a separate list per vertex.
class Fans {
public:
    Fans(const std::vector<Corners>& triangles, std::size_t vertices) : starts_(vertices + 1, 0) {
        for (const Corners& corners : triangles)
            for (const std::uint32_t vertex : corners) ++starts_[vertex + 1];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        corners_.resize(3 * triangles.size());
        for (std::uint32_t corner = 0; corner < corners_.size(); ++corner)
            corners_[next[triangles[corner / 3][corner % 3]]++] = corner;
    }
    /// Corner 3 t + i is corner i of triangle t.
    std::span<const std::uint32_t> of(std::size_t vertex) const {
        return std::span(corners_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }

private:
    std::vector<std::uint32_t> starts_, corners_;
};

class Shading {
public:
    Shading(const TriangleMesh& mesh, double crease, const FaceColours& colours)
        : vertices_(mesh.vertices)
        , cosine_(std::cos(crease))
        , triangles_(usable(mesh, colours))
        , fans_(triangles_, mesh.vertices.size()) {}

    ShadedMesh make() {
        ShadedMesh result;
        result.triangles.resize(3 * triangles_.size());
        for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) shadeFan(fans_.of(vertex), vertex, result);
        for (std::uint32_t triangle = 0; triangle < triangles_.size(); ++triangle)
            for (std::uint32_t i = 0; i < 3; ++i) addCrease(triangle, i, result);
        return result;
    }

private:
    std::vector<Corners> usable(const TriangleMesh& mesh, const FaceColours& colours) {
        const std::vector<std::uint32_t> first = firstAtSamePlace(mesh);
        std::vector<Corners> kept;
        kept.reserve(mesh.triangles.size());
        auto next = colours.begin();
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            while (next != colours.end() && i >= std::size_t{next->first} + next->count) ++next;
            const Corners& corners = mesh.triangles[i];
            const Corners merged{first[corners[0]], first[corners[1]], first[corners[2]]};
            const glm::dvec3 area =
                glm::cross(vertices_[merged[1]] - vertices_[merged[0]], vertices_[merged[2]] - vertices_[merged[0]]);
            const double length = glm::length(area);
            if (!(length > 0.0)) continue;
            kept.push_back(merged);
            normals_.push_back(area / length);
            if (colours.empty()) continue;
            const bool own = next != colours.end() && i >= next->first;
            colours_.push_back(own ? PointColour{next->colour[0], next->colour[1], next->colour[2], 255}
                                   : PointColour{});
        }
        return kept;
    }

    double angleAt(std::uint32_t corner) const {
        const Corners& c = triangles_[corner / 3];
        const glm::dvec3& tip = vertices_[c[corner % 3]];
        const glm::dvec3 a = vertices_[c[(corner % 3 + 1) % 3]] - tip;
        const glm::dvec3 b = vertices_[c[(corner % 3 + 2) % 3]] - tip;
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    /// The normal of a corner: the mean of all triangles around it within the crease angle, weighted by their angle.
    void shadeFan(std::span<const std::uint32_t> fan, std::size_t vertex, ShadedMesh& result) const {
        const std::size_t firstPoint = result.points.size();
        for (const std::uint32_t corner : fan) {
            const glm::dvec3& own = normals_[corner / 3];
            glm::dvec3 sum(0.0);
            for (const std::uint32_t other : fan)
                if (glm::dot(own, normals_[other / 3]) >= cosine_) sum += normals_[other / 3] * angleAt(other);
            const double length = glm::length(sum);
            const glm::vec3 normal(length > 0.0 ? sum / length : own);
            std::size_t point = firstPoint;
            while (point < result.points.size() &&
                   (glm::dot(result.normals[point], normal) < 0.99999F || !hasColour(result, point, corner / 3)))
                ++point;
            if (point == result.points.size()) {
                result.points.emplace_back(vertices_[vertex]);
                result.normals.push_back(normal);
                if (!colours_.empty()) result.colours.push_back(colours_[corner / 3]);
            }
            result.triangles[corner] = static_cast<std::uint32_t>(point);
        }
    }

    bool hasColour(const ShadedMesh& result, std::size_t point, std::uint32_t triangle) const {
        return colours_.empty() || result.colours[point] == colours_[triangle];
    }

    /// Adds the edge from corner i to the next one; only the triangle in which it runs towards the larger index adds
    /// it.
    void addCrease(std::uint32_t triangle, std::uint32_t i, ShadedMesh& result) const {
        const std::uint32_t from = triangles_[triangle][i], to = triangles_[triangle][(i + 1) % 3];
        if (from > to) return;
        for (const std::uint32_t corner : fans_.of(from)) {
            const Corners& other = triangles_[corner / 3];
            if (other[(corner % 3 + 2) % 3] != to) continue; // only the neighbour has the edge in reverse
            if (glm::dot(normals_[triangle], normals_[corner / 3]) >= cosine_) return;
        }
        result.creases.push_back(result.triangles[3 * triangle + i]);
        result.creases.push_back(result.triangles[3 * triangle + (i + 1) % 3]);
    }

    const std::vector<glm::dvec3>& vertices_;
    double cosine_;
    std::vector<glm::dvec3> normals_;  ///< one per triangle
    std::vector<PointColour> colours_; ///< one per triangle; empty: none has its own
    std::vector<Corners> triangles_;
    Fans fans_;
};

} // namespace

std::optional<double> distanceAlong(const ShadedMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction) {
    std::optional<double> nearest;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const Triangle triangle{mesh.points[mesh.triangles[i]], mesh.points[mesh.triangles[i + 1]],
                                mesh.points[mesh.triangles[i + 2]]};
        const std::optional<TriangleHit> hit = hitOf({origin, direction}, triangle);
        if (hit && (!nearest || hit->distance < *nearest)) nearest = hit->distance;
    }
    return nearest;
}

ShadedMesh shaded(const TriangleMesh& mesh, double crease, const FaceColours& colours) {
    return Shading(mesh, crease, colours).make();
}

} // namespace burin
