// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// A half-line from the eye, or from far before everything in a parallel picture; setup frame.
struct Sight {
    glm::dvec3 origin{0.0};               ///< mm
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit
    bool parallel = false;                ///< all sights of the picture have this direction, and origins of their own
};

} // namespace burin
