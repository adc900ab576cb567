// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BRepAdaptor_Surface.hxx>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// The triangles of one face of a shape, each corner with its place in the surface's parameters. Along a seam two nodes
/// stand for one point.
struct FaceMesh {
    std::vector<std::uint32_t> nodes;                    ///< number of the point that a node stands for
    std::vector<glm::dvec2> parameters;                  ///< u and v of each node; empty when they are not known
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< of nodes
};

/// Splits triangles until edge middles and triangle centres lie within `chord` mm of the surface: OpenCASCADE's mesher
/// overshoots its own deflection, on freeform faces several times. The border of the face stays as it is, so that it
/// fits its neighbours. New points are added to `points`.
void refineFace(const BRepAdaptor_Surface& surface, double chord, FaceMesh& face, std::vector<glm::dvec3>& points);

} // namespace burin
