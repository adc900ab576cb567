// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"
#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Puts a mesh where a placement says; of one that mirrors the triangles are turned over, so that they still are
/// counter-clockwise seen from outside.
void place(TriangleMesh& mesh, const Placement& placement);

/// A mesh in parts, each with the vertices that it uses and its triangles in their order.
/// @param partOf  of each triangle the number of its part; `parts` or more: of none
std::vector<TriangleMesh> partsOf(const TriangleMesh& mesh, std::span<const std::uint32_t> partOf, std::size_t parts);

} // namespace burin
