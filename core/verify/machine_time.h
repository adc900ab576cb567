// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/parser.h"

#include <vector>

namespace burin {

/// The time at which the machine makes a motion of the program.
struct MotionTime {
    double start = 0.0;     ///< s from the beginning of the program
    double duration = 0.0;  ///< s; of a dwell, its length
    double peakSpeed = 0.0; ///< mm/s that the tip reaches
};

/// A line from which on the program states how its control takes corners.
struct StatedPathMode {
    std::uint32_t line = 0; ///< of the first motion that it applies to
    PathMode mode = PathMode::blend;
    double tolerance = 0.0; ///< mm, of blend; 0: without limit
};
/// All changes, in program order; empty if the machine's own rule applies throughout.
std::vector<StatedPathMode> statedPathModes(const ParsedProgram& program);

/// The time that a program takes on a machine.
struct MachiningTime {
    std::vector<MotionTime> motions; ///< by index in ParsedProgram::motions
    double seconds = 0.0;            ///< total, including tool changes and dwells
    /// s: at the programmed feeds and the machine's rapid rates, without any accelerations
    double withoutAcceleration = 0.0;
    int toolChanges = 0; ///< including the first tool's
    /// Moves that are not included because the program does not determine where they begin or end: the first ones, and
    /// those in the machine's frame (G28, G30, G53).
    int untimedMoves = 0;
};

/// Plans every motion as a control with unlimited look-ahead does: with trapezoidal speed profiles along each block, or
/// S-curves where the machine limits jerk. The speed at both ends is limited by the junction rule of the program, or
/// else of the machine, by the length of the block and by the blocks around it; no axis exceeds its rate or
/// acceleration; the speed on arcs is at most sqrt(a r); the number of blocks a second is at most what the control can
/// execute. core/verify/README.md states the rules and what is left out. A motion from a position that the program has
/// not set takes no time.
MachiningTime machiningTime(const ParsedProgram& program, const MachineProfile& machine);

} // namespace burin
