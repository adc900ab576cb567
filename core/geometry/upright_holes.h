// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle.h"

#include <span>
#include <vector>

namespace burin {

/// A round hole with an upright axis in a solid, or a stud of it, mm, frame of its triangles.
struct UprightHole {
    glm::dvec2 centre{0.0};
    double radius = 0.0;      ///< of the circle through the corners of its wall
    double clearRadius = 0.0; ///< of the largest cylinder between its facets: what fits into the mesh of a hole
    double top = 0.0;         ///< highest point of its wall
    double bottom = 0.0;      ///< lowest point of its wall
    bool stud = false;        ///< the solid is inside of its wall
};

/// Finds round holes with an upright axis: walls whose corners lie within 0.01 mm of one circle, all the way around it,
/// with the solid outside. Interrupted walls with the same axis and radius are one hole. Facets may bend by at most
/// 40°, so that a hexagon does not count. Sorted by x, then y. Any thread. Cost: grows with all triangles.
std::vector<UprightHole> uprightHoles(std::span<const Triangle> triangles);
/// The same for studs: round walls with the solid inside.
std::vector<UprightHole> uprightStuds(std::span<const Triangle> triangles);

/// The narrowest hole (or stud) around a point in plan: of a counterbore, the hole in it. Null: there is none.
const UprightHole* holeAround(std::span<const UprightHole> holes, const glm::dvec2& place) noexcept;

} // namespace burin
