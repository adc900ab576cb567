// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <glm/glm.hpp>

namespace burin {

struct CylinderShape {
    glm::dvec3 base{0.0};           ///< mm, centre of the lower face, setup frame
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< unit
    double radius = 0.0;            ///< mm, > 0
    double height = 0.0;            ///< mm, > 0

    friend bool operator==(const CylinderShape&, const CylinderShape&) = default;
};

/// Returns the smallest axis-aligned box around the cylinder, mm.
Box boxAround(const CylinderShape& cylinder);

} // namespace burin
