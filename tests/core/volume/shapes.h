// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/geometry/triangle_mesh.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace burin::test {

inline TriangleMesh boxMesh(const glm::dvec3& low, const glm::dvec3& high) {
    TriangleMesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                                   (corner & 4U) != 0 ? high.z : low.z);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// A closed surface over a grid of two angles; `wrapV` false closes it at two poles (the first and last row).
template <class Place>
TriangleMesh angularMesh(std::uint32_t countU, std::uint32_t countV, bool wrapV, Place place) {
    TriangleMesh mesh;
    const std::uint32_t rows = wrapV ? countV : countV + 1;
    for (std::uint32_t v = 0; v < rows; ++v)
        for (std::uint32_t u = 0; u < countU; ++u) mesh.vertices.push_back(place(u, v));
    const auto at = [&](std::uint32_t u, std::uint32_t v) { return (v % rows) * countU + u % countU; };
    for (std::uint32_t v = 0; v < countV; ++v)
        for (std::uint32_t u = 0; u < countU; ++u) {
            mesh.triangles.push_back({at(u, v), at(u + 1, v), at(u + 1, v + 1)});
            mesh.triangles.push_back({at(u, v), at(u + 1, v + 1), at(u, v + 1)});
        }
    return weldIdenticalVertices(mesh);
}

inline TriangleMesh sphereMesh(const glm::dvec3& centre, double radius, std::uint32_t count) {
    return angularMesh(2 * count, count, false, [=](std::uint32_t u, std::uint32_t v) {
        if (v == 0 || v == count) return centre + glm::dvec3(0, 0, v == 0 ? -radius : radius);
        const double a = pi * u / count, b = pi * v / count;
        return centre + radius * glm::dvec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), -std::cos(b));
    });
}

inline TriangleMesh torusMesh(const glm::dvec3& centre, double radius, double tube, std::uint32_t count) {
    return angularMesh(2 * count, count, true, [=](std::uint32_t u, std::uint32_t v) {
        const double a = pi * u / count, b = 2 * pi * v / count;
        const double reach = radius + tube * std::cos(b);
        return centre + glm::dvec3(reach * std::cos(a), reach * std::sin(a), tube * std::sin(b));
    });
}

inline TriangleMesh turned(TriangleMesh mesh, double angle, const glm::dvec3& axis, const glm::dvec3& about) {
    const glm::dquat turn = glm::angleAxis(angle, glm::normalize(axis));
    for (glm::dvec3& point : mesh.vertices) point = about + turn * (point - about);
    return mesh;
}

} // namespace burin::test
