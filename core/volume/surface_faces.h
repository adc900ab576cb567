// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace burin {

/// Where to look the corners of the quadrangles around edges up: each is the point at the place of the edge's start in
/// one of these. Counter-clockwise as seen from the far end of an edge that starts inside.
using QuadrangleCorners = std::array<const std::uint32_t*, 4>;

/// Two triangles for each crossed edge (`SurfaceCrossings`): the quadrangle around it, split along its shorter
/// diagonal.
/// @param points    mm; behind the last there is room for one more number
/// @param triangles room for six corners an edge
void writeSurfaceFaces(std::span<const std::uint32_t> edges, const QuadrangleCorners& corners, const glm::vec3* points,
                       std::uint32_t* triangles) noexcept;

} // namespace burin
