// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Closed, outward-oriented meshes of shapes whose distance is known by formula. All lengths in mm.
namespace burin::shapes {

/// Points of a closed grid, `columns` around and `rows` around: a torus-like mesh.
template <class Point>
TriangleMesh wrapped(std::uint32_t columns, std::uint32_t rows, const Point& point) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) mesh.vertices.push_back(point(i, j));
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const std::uint32_t a = i * rows + j, b = (i + 1) % columns * rows + j;
            const std::uint32_t c = (i + 1) % columns * rows + (j + 1) % rows, d = i * rows + (j + 1) % rows;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

inline TriangleMesh torus(double major, double minor, std::uint32_t columns, std::uint32_t rows) {
    return wrapped(columns, rows, [&](std::uint32_t i, std::uint32_t j) {
        const double u = 2.0 * std::numbers::pi * i / columns, v = 2.0 * std::numbers::pi * j / rows;
        const double r = major + minor * std::cos(v);
        return glm::dvec3(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    });
}

/// A tube about Z, from height 0 up, its corners on the two radii.
inline TriangleMesh tube(double outer, double inner, double height, std::uint32_t columns) {
    return wrapped(columns, 4, [&](std::uint32_t i, std::uint32_t j) {
        const double u = 2.0 * std::numbers::pi * i / columns, r = j == 0 || j == 3 ? inner : outer;
        return glm::dvec3(r * std::cos(u), r * std::sin(u), j < 2 ? 0.0 : height);
    });
}

/// @param radius as a function of longitude and latitude, including bumps
template <class Radius>
TriangleMesh starShaped(std::uint32_t columns, std::uint32_t rows, const Radius& radius) {
    TriangleMesh mesh;
    const auto point = [&](double longitude, double latitude) {
        const double r = radius(longitude, latitude);
        return glm::dvec3(r * std::cos(latitude) * std::cos(longitude), r * std::cos(latitude) * std::sin(longitude),
                          r * std::sin(latitude));
    };
    mesh.vertices.push_back(point(0.0, -0.5 * std::numbers::pi));
    for (std::uint32_t j = 1; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i)
            mesh.vertices.push_back(
                point(2.0 * std::numbers::pi * i / columns, std::numbers::pi * (double(j) / rows - 0.5)));
    mesh.vertices.push_back(point(0.0, 0.5 * std::numbers::pi));
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (j - 1) * columns + i % columns; };
    for (std::uint32_t i = 0; i < columns; ++i) {
        mesh.triangles.push_back({0, at(i + 1, 1), at(i, 1)});
        mesh.triangles.push_back({last, at(i, rows - 1), at(i + 1, rows - 1)});
        for (std::uint32_t j = 1; j + 1 < rows; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

inline TriangleMesh sphere(double radius, std::uint32_t columns, std::uint32_t rows) {
    return starShaped(columns, rows, [&](double, double) { return radius; });
}

/// A solid of boxes: the cells of a non-uniform grid for which `filled(i, j, k)` is true; inner faces are left out.
template <class Filled>
TriangleMesh cells(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                   const Filled& filled) {
    TriangleMesh mesh;
    const int nx = int(x.size()) - 1, ny = int(y.size()) - 1, nz = int(z.size()) - 1;
    const auto solid = [&](int i, int j, int k) {
        return i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz && filled(i, j, k);
    };
    const auto vertex = [&](int i, int j, int k) {
        mesh.vertices.push_back({x[std::size_t(i)], y[std::size_t(j)], z[std::size_t(k)]});
    };
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            for (int k = 0; k < nz; ++k) {
                if (!solid(i, j, k)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    for (int side = 0; side < 2; ++side) {
                        const int step = side == 0 ? -1 : 1;
                        if (solid(i + (axis == 0) * step, j + (axis == 1) * step, k + (axis == 2) * step)) continue;
                        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
                        for (const auto& [cu, cv] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                            int at[3] = {i, j, k};
                            at[axis] += side;
                            at[u] += cu;
                            at[v] += cv;
                            vertex(at[0], at[1], at[2]);
                        }
                        if (side == 1) {
                            mesh.triangles.push_back({first, first + 1, first + 2});
                            mesh.triangles.push_back({first, first + 2, first + 3});
                        } else {
                            mesh.triangles.push_back({first, first + 2, first + 1});
                            mesh.triangles.push_back({first, first + 3, first + 2});
                        }
                    }
            }
    return weldIdenticalVertices(mesh);
}

inline TriangleMesh box(const glm::dvec3& low, const glm::dvec3& high) {
    return cells({low.x, high.x}, {low.y, high.y}, {low.z, high.z}, [](int, int, int) { return true; });
}

/// A block from (-outer, -outer, -height) to (outer, outer, 0) with a square pocket of half width `inner`, `depth`
/// deep.
inline TriangleMesh pocket(double outer, double height, double inner, double depth) {
    return cells({-outer, -inner, inner, outer}, {-outer, -inner, inner, outer}, {-height, -depth, 0.0},
                 [](int i, int j, int k) { return !(i == 1 && j == 1 && k == 1); });
}

/// Signed distance to an axis-aligned box, by formula.
inline double boxDistance(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& p) {
    const glm::dvec3 q = glm::abs(p - 0.5 * (low + high)) - 0.5 * (high - low);
    return glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

} // namespace burin::shapes
