// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// A half-line from the eye, setup frame.
struct Sight {
    glm::dvec3 origin{0.0};                ///< mm
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
};

} // namespace burin
