// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BRepAdaptor_Surface.hxx>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// The triangles of one face of a shape, with the surface parameters of each corner. Along a seam two nodes represent
/// the same point.
struct FaceMesh {
    std::vector<std::uint32_t> nodes;                    ///< index of the point that a node represents
    std::vector<glm::dvec2> parameters;                  ///< u and v of each node; empty if they are not known
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of nodes
};

/// Splits triangles until edge midpoints and triangle centres lie within `chord` mm of the surface: OpenCASCADE's
/// mesher exceeds its own deflection, several times over on freeform faces. The border of the face stays unchanged, so
/// that it fits its neighbours. New points are added to `points`.
void refineFace(const BRepAdaptor_Surface& surface, double chord, FaceMesh& face, std::vector<glm::dvec3>& points);

} // namespace burin
