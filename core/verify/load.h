// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace burin {

/// What one motion of a program asks of tool and spindle, in the mean over the motion.
struct MotionLoad {
    std::uint32_t motion = 0; ///< place in ParsedProgram::motions
    std::uint32_t line = 0;
    double start = 0.0;       ///< s
    double duration = 0.0;    ///< s
    double volume = 0.0;      ///< mm³ removed
    double removalRate = 0.0; ///< mm³/s
    double force = 0.0;    ///< N, tangential, at the flutes' edge; 0 where the spindle stands or the material has no K
    double power = 0.0;    ///< W at the cutter: K times the removal rate
    glm::dvec3 place{0.0}; ///< mm, setup frame, centre of what is removed
};

} // namespace burin
