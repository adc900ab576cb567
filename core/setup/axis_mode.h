// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// What the tool's axis does while it mills.
struct AxisMode {
    bool free = false;                   ///< it follows the stylus; else it stands (three axes, or 3+2)
    glm::dvec3 direction{0.0, 0.0, 1.0}; ///< unit, setup frame, towards the holder: where it stands
};

} // namespace burin
