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

/// Angle-weighted pseudo-normals of a mesh: the sign of their product with the way from the nearest point of a closed
/// mesh tells inside from outside without exception (J. A. Bærentzen and H. Aanæs, Signed distance computation using
/// the angle weighted pseudonormal, IEEE TVCG 11, 2005).
class SurfaceNormals {
public:
    /// @param merged `firstAtSamePlace` of the mesh
    /// @param order the triangles of `mesh` in the order that slots are counted in
    /// @param thin mm: a triangle that is lower than that over its longest edge has no normal to trust
    SurfaceNormals(const TriangleMesh& mesh, std::span<const std::uint32_t> merged,
                   std::span<const std::uint32_t> order, double thin);

    /// Pseudo-normal, not of unit length, at a feature of the triangle in a slot. None where the mesh around it is not
    /// an ordinary closed surface (an open edge, an edge of more than two triangles, a triangle that is thin or without
    /// area).
    std::optional<glm::dvec3> at(std::span<const Triangle> triangles, std::size_t slot,
                                 TriangleFeature feature) const noexcept;

    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    /// Slots of the triangles beyond the edges ab, bc, ca of the one in a slot; `none` where no ordinary surface goes
    /// on.
    const std::array<std::uint32_t, 3>& neighbours(std::size_t slot) const noexcept { return neighbours_[slot]; }

private:
    double thin_;                                          ///< mm
    std::vector<std::array<std::uint32_t, 3>> corners_;    ///< per slot: vertices, identical ones merged
    std::vector<std::array<std::uint32_t, 3>> neighbours_; ///< per slot: the slot beyond edge ab, bc, ca
    std::vector<glm::dvec3> vertexNormals_;                ///< zero where there is none to trust
};

/// Share of a point's surroundings that a triangle takes up when the point lies on the given feature of it: the weight
/// of the triangle's unit normal in the pseudo-normal, rad.
double surroundingAngle(const Triangle& triangle, TriangleFeature feature) noexcept;

/// Its rounding, or a fold of it, decides which way its normal points: it is lower than `thin` mm over its longest
/// edge.
bool isThin(const Triangle& triangle, double thin) noexcept;

/// Unit normal; zero for a triangle without area.
glm::dvec3 unitNormal(const Triangle& triangle) noexcept;

} // namespace burin
