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

/// Applies a placement to a mesh. If the placement mirrors, the triangles are flipped so that they remain
/// counter-clockwise seen from outside.
void place(TriangleMesh& mesh, const Placement& placement);

/// Splits a mesh into parts, each with only the vertices that it uses and with its triangles in their original order.
/// @param partOf  the part number of each triangle; `parts` or more: in no part
std::vector<TriangleMesh> partsOf(const TriangleMesh& mesh, std::span<const std::uint32_t> partOf, std::size_t parts);

} // namespace burin
