// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle.h"

#include <span>
#include <vector>

namespace burin {

/// A round hole with an upright axis in a solid, mm, frame of its triangles.
struct UprightHole {
    glm::dvec2 centre{0.0};
    double radius = 0.0;      ///< of the circle through the corners of its wall
    double clearRadius = 0.0; ///< of the largest cylinder between its facets: what fits into the mesh
    double top = 0.0;         ///< highest point of its wall
    double bottom = 0.0;      ///< lowest point of its wall
};

/// Round holes with an upright axis: walls whose corners lie within 0.01 mm of one circle, all the way round it, with
/// the solid outside. Walls of one axis and radius that something interrupts are one hole. Facets may bend by 40° at
/// most, so that a hexagon is none. Sorted by x, then y. Any thread. Cost: all triangles.
std::vector<UprightHole> uprightHoles(std::span<const Triangle> triangles);

} // namespace burin
