// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/obstacle.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

TriangleMesh meshOf(const Box& box) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(
            {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A prism around the cylinder.
TriangleMesh meshOf(const CylinderShape& cylinder) {
    const glm::dvec3 other = std::abs(cylinder.axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(cylinder.axis, other)), y = glm::cross(cylinder.axis, x);
    const double half = std::acos(cylinder.radius / (cylinder.radius + cylinderChord));
    const auto sides = static_cast<std::uint32_t>(std::clamp(std::ceil(pi / half), 8.0, 4096.0));
    const double radius = cylinder.radius / std::cos(pi / sides);
    TriangleMesh mesh;
    const glm::dvec3 rise = cylinder.height * cylinder.axis;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2.0 * pi * i / sides;
        const glm::dvec3 place = cylinder.base + radius * (std::cos(angle) * x + std::sin(angle) * y);
        mesh.vertices.push_back(place);
        mesh.vertices.push_back(place + rise);
    }
    const std::uint32_t bottom = 2 * sides, top = bottom + 1;
    mesh.vertices.push_back(cylinder.base);
    mesh.vertices.push_back(cylinder.base + rise);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
        mesh.triangles.push_back({bottom, b, a});
        mesh.triangles.push_back({top, a + 1, b + 1});
    }
    return mesh;
}

TriangleMesh meshOf(const TriangleMesh& mesh) {
    return mesh;
}

} // namespace

TriangleMesh meshOf(const Obstacle& obstacle) {
    return std::visit([](const auto& shape) { return meshOf(shape); }, obstacle.shape);
}

} // namespace burin
