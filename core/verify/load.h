// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace burin {

/// The load of a cut on tool and spindle at one moment of a program. Forces are means over a turn of the spindle; they
/// are 0 where the spindle stands still or the material has no K.
struct CutLoad {
    double at = 0.0;           ///< s from the beginning of the program
    glm::dvec3 place{0.0};     ///< mm, setup frame, centre of the material removed
    double removalRate = 0.0;  ///< mm³/s
    double force = 0.0;        ///< N, tangential: the power divided by the speed of the flutes' edge
    double radial = 0.0;       ///< N: Kr times the tangential force of the chip, plus Kre of the edge
    double axial = 0.0;        ///< N, on the tool, along its axis towards the holder
    double side = 0.0;         ///< N, on the tool, across its axis: bends the tool
    glm::dvec3 vector{0.0};    ///< N, on the tool, setup frame
    double power = 0.0;        ///< W at the cutter
    double torque = 0.0;       ///< N m at the spindle
    double feedPerTooth = 0.0; ///< mm
    double chip = 0.0;         ///< mm, mean thickness over the engaged surface
    double depth = 0.0;        ///< mm along the axis
    double width = 0.0;  ///< mm across the axis and the move: area of the cut seen along the move, divided by its depth
    double height = 0.0; ///< mm above the tip, middle of the engaged part
};

/// The load of one motion of a program on tool and spindle: its mean over the motion, and its peak.
struct MotionLoad {
    std::uint32_t motion = 0; ///< index in ParsedProgram::motions
    std::uint32_t line = 0;
    double start = 0.0;       ///< s
    double duration = 0.0;    ///< s
    double volume = 0.0;      ///< mm³ removed
    double removalRate = 0.0; ///< mm³/s, mean
    double force = 0.0; ///< N, tangential, at the flutes' edge, mean; 0 where the spindle stands still or there is no K
    double power = 0.0; ///< W at the cutter, mean
    glm::dvec3 place{0.0}; ///< mm, setup frame, centroid of the material removed
    CutLoad peak;          ///< where the force is greatest, or the removal rate if no force is known
};

/// The load over time: an interval for which it is reported as one value.
struct LoadStep {
    float start = 0.0F, duration = 0.0F; ///< s
    float force = 0.0F;                  ///< N, tangential
    float power = 0.0F;                  ///< W
    std::uint32_t motion = 0;            ///< index in ParsedProgram::motions
};

} // namespace burin
