// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// A mesh as it is drawn: a point for each normal, so that an edge keeps its crease.
struct ShadedMesh {
    std::vector<glm::vec3> points;        ///< mm
    std::vector<glm::vec3> normals;       ///< unit, outwards, a point each
    std::vector<std::uint32_t> triangles; ///< three corners each
    std::vector<std::uint32_t> creases;   ///< two ends each: edges that are drawn as lines
};

/// Between normals of two triangles that meet at an edge of a solid, rad.
inline constexpr double creaseAngle = 25.0 * pi / 180.0;

/// Smooth where neighbouring triangles differ by less than `crease` (rad), sharp elsewhere. Triangles without area are
/// left out. Any thread; cost: linear.
ShadedMesh shaded(const TriangleMesh& mesh, double crease);

/// Distance, in lengths of `direction`, to the nearest triangle that a ray meets, from either side. Nothing: it misses.
/// Cost: linear.
std::optional<double> distanceAlong(const ShadedMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction);

} // namespace burin
