// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/geometry/shapes.h"

namespace burin::benchmarks {

/// A closed bumpy body in the middle of a scene of `side` voxels of 1 mm, smooth at its poles too: no radius of
/// curvature is less than a twentieth of `side`. @param triangles  their approximate number
inline TriangleMesh bumpyPart(double side, double triangles) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(0.25 * triangles))) + 1;
    TriangleMesh mesh = shapes::starShaped(2 * rows, rows, [=](double longitude, double latitude) {
        const double fade = std::cos(latitude) * std::cos(latitude) * std::cos(latitude); // bumps fade out at the poles
        return 0.42 * side * (1.0 + 0.03 * std::sin(9.0 * longitude) * std::sin(7.0 * latitude) * fade);
    });
    for (glm::dvec3& vertex : mesh.vertices) vertex += glm::dvec3(0.5 * side);
    return mesh;
}

/// A block with a square pocket: sharp convex and concave edges, none of them on the border of a voxel.
inline TriangleMesh sharpPart(double side) {
    TriangleMesh mesh = shapes::pocket(0.31 * side, 0.4 * side, 0.17 * side, 0.19 * side);
    for (glm::dvec3& vertex : mesh.vertices) vertex += glm::dvec3(0.503, 0.497, 0.71) * side;
    return mesh;
}

} // namespace burin::benchmarks
