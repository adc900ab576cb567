// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Angle-weighted pseudo-normals of a mesh: the sign of their product with the vector from the nearest point of a
/// closed mesh always distinguishes inside from outside (J. A. Bærentzen and H. Aanæs, Signed distance computation
/// using the angle weighted pseudonormal, IEEE TVCG 11, 2005).
class SurfaceNormals {
public:
    /// @param merged  `firstAtSamePlace` of the mesh
    /// @param order  the triangles of `mesh` in the order of their slots
    /// @param thin  mm: a triangle whose height over its longest edge is less than this has no reliable normal
    SurfaceNormals(const TriangleMesh& mesh, std::span<const std::uint32_t> merged,
                   std::span<const std::uint32_t> order, double thin);

    /// Pseudo-normal, not of unit length, at a feature of the triangle in a slot. Empty if the mesh around it is not an
    /// ordinary closed surface (an open edge, an edge of more than two triangles, a triangle that is thin or without
    /// area).
    std::optional<glm::dvec3> at(std::span<const Triangle> triangles, std::size_t slot,
                                 TriangleFeature feature) const noexcept;

    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    /// Slots of the triangles beyond the edges ab, bc, ca of the one in a slot; `none` if no ordinary surface continues
    /// there.
    const std::array<std::uint32_t, 3>& neighbours(std::size_t slot) const noexcept { return neighbours_[slot]; }

private:
    double thin_;                                          ///< mm
    std::vector<std::array<std::uint32_t, 3>> corners_;    ///< per slot: vertices, identical ones merged
    std::vector<std::array<std::uint32_t, 3>> neighbours_; ///< per slot: the slot beyond edge ab, bc, ca
    std::vector<glm::dvec3> vertexNormals_;                ///< zero if there is no reliable one
};

/// Angle that a triangle takes up around a point on the given feature of it, rad: the weight of the triangle's unit
/// normal in the pseudo-normal.
double surroundingAngle(const Triangle& triangle, TriangleFeature feature) noexcept;

/// Whether the triangle's height over its longest edge is less than `thin` mm, so that rounding, or a fold, determines
/// the direction of its normal.
bool isThin(const Triangle& triangle, double thin) noexcept;

} // namespace burin
