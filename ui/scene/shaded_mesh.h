// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/cad/face_colours.h"
#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// A mesh for drawing: one point for each normal, so that sharp edges remain sharp.
struct ShadedMesh {
    std::vector<glm::vec3> points;        ///< mm
    std::vector<glm::vec3> normals;       ///< unit, outwards, one per point
    std::vector<std::uint32_t> triangles; ///< three corners each
    std::vector<std::uint32_t> creases;   ///< two ends each: edges that are drawn as lines
    /// sRGB and opacity of each point: that of its face, or opacity 0 if the face has the colour of its body; empty: no
    /// face has a colour of its own.
    std::vector<std::array<std::uint8_t, 4>> colours;
};

/// The angle between the normals of two triangles from which their common edge is sharp, for a solid, rad.
inline constexpr double creaseAngle = 25.0 * pi / 180.0;

/// Shades a mesh smoothly where the normals of neighbouring triangles differ by less than `crease` (rad), with sharp
/// edges elsewhere. Triangles without area are dropped. Any thread; cost: linear.
/// @param colours of the mesh's faces; points between faces of different colours are made for each of them
ShadedMesh shaded(const TriangleMesh& mesh, double crease, const FaceColours& colours = {});

/// The distance, in lengths of `direction`, to the nearest triangle that a ray hits, from either side; std::nullopt if
/// it misses. Cost: linear.
std::optional<double> distanceAlong(const ShadedMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction);

} // namespace burin
