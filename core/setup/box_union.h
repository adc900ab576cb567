// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle_mesh.h"

#include <span>

namespace burin {

/// Returns the surface of all boxes together, less the boxes that are cut away: closed, oriented outwards, with shared
/// vertices. Boxes that touch in nothing but an edge leave that edge open for countOpenEdges. Coordinates that differ
/// by less than 1e-9 mm count as the same. Cost grows with the cube of the number of boxes.
TriangleMesh boxUnion(std::span<const Box> boxes, std::span<const Box> cutAway);

} // namespace burin
