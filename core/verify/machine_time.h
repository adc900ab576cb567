// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/parser.h"

#include <vector>

namespace burin {

/// When the machine makes a motion of the program.
struct MotionTime {
    double start = 0.0;     ///< s from the beginning of the program
    double duration = 0.0;  ///< s; of a dwell its length
    double peakSpeed = 0.0; ///< mm/s that the tip reaches in it
};

/// From a line on the program says how its control is to take corners.
struct StatedPathMode {
    std::uint32_t line = 0; ///< of the first motion that it holds for
    PathMode mode = PathMode::blend;
    double tolerance = 0.0; ///< mm, of blend; 0: without limit
};
/// All changes, in program order; empty where the machine's own rule holds throughout.
std::vector<StatedPathMode> statedPathModes(const ParsedProgram& program);

/// What a program takes on a machine.
struct MachiningTime {
    std::vector<MotionTime> motions;  ///< by place in ParsedProgram::motions
    double seconds = 0.0;             ///< in all, tool changes and dwells included
    double withoutAcceleration = 0.0; ///< s: at the programmed feeds and the machine's rapids, with nothing but them
    int toolChanges = 0;              ///< the first tool's included
    /// Moves that are not in it, as the program does not say where they begin or end: the first ones, and those in the
    /// machine's frame (G28, G30, G53).
    int untimedMoves = 0;
};

/// Plans every motion as a control with unlimited look-ahead would: trapezoids of speed along each block, S-curves
/// where the machine limits jerk, as fast at both ends as the junction rule of the program, else of the machine, the
/// block's own length and the blocks around it allow; no axis beyond its rate or acceleration; arcs no faster than
/// sqrt(a r); no more blocks a second than the control carries out. core/verify/README.md states the rules and what is
/// left out. A motion from a place that the program has not set takes no time.
MachiningTime machiningTime(const ParsedProgram& program, const MachineProfile& machine);

} // namespace burin
