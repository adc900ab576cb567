// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// A corner of a polygon: its position in the plane and the vertex that it represents.
struct PolygonCorner {
    glm::dvec2 place{0.0};
    std::uint32_t vertex = 0;
};

/// Fills a polygon with holes with triangles, using each edge of each loop exactly once and no additional corners. So
/// the surface closes whatever the shape of the loops, even if they touch or cross slightly, as the rounded edges of
/// real files do. The triangles are counter-clockwise.
/// @param loops the outer loop counter-clockwise first, then the holes clockwise; each with three corners or more.
/// @param loops the outer loop counter-clockwise first, then the holes clockwise; each with three corners or more.
/// Cost: the square of the number of corners. Method: ear clipping, holes joined by bridges (D. Eberly, "Triangulation
/// by Ear Clipping", Geometric Tools 2002).
std::vector<std::array<std::uint32_t, 3>> fillPolygon(std::vector<std::vector<PolygonCorner>> loops);

} // namespace burin
