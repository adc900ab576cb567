// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// How the tool axis is oriented while milling.
struct AxisMode {
    bool free = false;                   ///< follows the stylus; otherwise fixed (three axes, or 3+2)
    glm::dvec3 direction{0.0, 0.0, 1.0}; ///< of a fixed axis: unit, setup frame, towards the holder
};

} // namespace burin
