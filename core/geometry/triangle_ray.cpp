// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle_ray.h"

#include "core/geometry/triangle_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// Where a ray enters boxes, as a lower bound of where it meets their content.
class AlongRay {
public:
    AlongRay(const TriangleTree& tree, const Ray& ray) noexcept
        : from_(ray.origin - tree.origin()), perLength_(1.0 / ray.direction) {}
    /// Only what is nearer counts.
    void limit(double distance) noexcept { limit_ = distance; }
    bool stillBelow(float bound) const noexcept { return static_cast<double>(bound) < limit_; }
    ChildBounds of(const TreeNode& node) const noexcept {
        ChildBounds bounds;
        for (std::size_t child = 0; child < TreeNode::width; ++child) {
            double in = 0.0, out = std::numeric_limits<double>::infinity();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int i = static_cast<int>(axis);
                const bool rises = !std::signbit(perLength_[i]);
                const TreeNode::Floats &nearer = rises ? node.low[axis] : node.high[axis],
                                       &farther = rises ? node.high[axis] : node.low[axis];
                // A ray that runs in a face gives NaN there, which sets no bound.
                in = std::max(in, (static_cast<double>(nearer[child]) - from_[i]) * perLength_[i]);
                out = std::min(out, (static_cast<double>(farther[child]) - from_[i]) * perLength_[i]);
            }
            // Rounded down, because the bound has only single precision.
            bounds[child] = in <= out ? static_cast<float>(in * (1.0 - 2e-7)) : std::numeric_limits<float>::infinity();
        }
        return bounds;
    }

private:
    glm::dvec3 from_, perLength_;
    double limit_ = std::numeric_limits<double>::infinity();
};

} // namespace

std::optional<TriangleHit> hitOf(const Ray& ray, const Triangle& triangle) noexcept {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 fromA = ray.origin - a, q = glm::cross(fromA, ab);
    const double u = glm::dot(fromA, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
    const double distance = glm::dot(ac, q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance >= 0.0)) return std::nullopt;
    return TriangleHit{distance, determinant < 0.0};
}

std::optional<TriangleHit> nearestHit(const Ray& ray, const TriangleTree& tree) noexcept {
    std::optional<TriangleHit> nearest;
    AlongRay bounds(tree, ray);
    walk(tree, bounds, [&](std::uint32_t slot) {
        const std::optional<TriangleHit> hit = hitOf(ray, tree.triangles()[slot]);
        if (!hit || (nearest && nearest->distance <= hit->distance)) return;
        nearest = hit;
        bounds.limit(hit->distance);
    });
    return nearest;
}

} // namespace burin
