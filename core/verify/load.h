// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace burin {

/// What a cut asks of tool and spindle at one moment of a program: forces in the mean over a turn of the spindle, 0
/// where it stands or the material has no K.
struct CutLoad {
    double at = 0.0;           ///< s from the beginning of the program
    glm::dvec3 place{0.0};     ///< mm, setup frame, middle of what is removed
    double removalRate = 0.0;  ///< mm³/s
    double force = 0.0;        ///< N, tangential: the power over the speed of the flutes' edge
    double radial = 0.0;       ///< N: Kr of what the chip takes of it, and Kre of the edge
    double axial = 0.0;        ///< N, on the tool, along its axis towards the holder
    double side = 0.0;         ///< N, on the tool, across its axis: what bends it
    glm::dvec3 vector{0.0};    ///< N, on the tool, setup frame
    double power = 0.0;        ///< W at the cutter
    double torque = 0.0;       ///< N m at the spindle
    double feedPerTooth = 0.0; ///< mm
    double chip = 0.0;         ///< mm, mean thickness over the surface that is engaged
    double depth = 0.0;        ///< mm along the axis
    double width = 0.0;        ///< mm across the axis and the move: what the cut shows along the move over its depth
    double height = 0.0;       ///< mm above the tip, middle of what is engaged
};

/// What one motion of a program asks of tool and spindle: in the mean over the motion, and at its peak.
struct MotionLoad {
    std::uint32_t motion = 0; ///< place in ParsedProgram::motions
    std::uint32_t line = 0;
    double start = 0.0;       ///< s
    double duration = 0.0;    ///< s
    double volume = 0.0;      ///< mm³ removed
    double removalRate = 0.0; ///< mm³/s, mean
    double force = 0.0;       ///< N, tangential, at the flutes' edge, mean; 0 where the spindle stands or there is no K
    double power = 0.0;       ///< W at the cutter, mean
    glm::dvec3 place{0.0};    ///< mm, setup frame, centre of what is removed
    CutLoad peak;             ///< where the force is greatest, or the removal rate where no force is known
};

/// The load over time: an interval in which it is told as one.
struct LoadStep {
    float start = 0.0F, duration = 0.0F; ///< s
    float force = 0.0F;                  ///< N, tangential
    float power = 0.0F;                  ///< W
    std::uint32_t motion = 0;            ///< place in ParsedProgram::motions
};

} // namespace burin
