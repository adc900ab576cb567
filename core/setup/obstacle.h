// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle_mesh.h"

#include <string>
#include <variant>

namespace burin {

struct CylinderShape {
    glm::dvec3 base{0.0};           ///< mm, middle of the lower face, setup frame
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< unit
    double radius = 0.0;            ///< mm, > 0
    double height = 0.0;            ///< mm, > 0
};

/// What a tool must stay out of besides the part: a fixture, or a space that is to be kept clear.
struct Obstacle {
    std::string name;
    std::variant<Box, CylinderShape, TriangleMesh> shape; ///< setup frame; a mesh is closed and outward
    double margin = 0.0;                                  ///< mm that the tool keeps from it, >= 0
    bool on = true;                                       ///< in force from the start
};

/// Its surface, closed and outward. A cylinder is never smaller than it says, and wider by `cylinderChord` at most.
TriangleMesh meshOf(const Obstacle& obstacle);
inline constexpr double cylinderChord = 0.005; ///< mm

} // namespace burin
