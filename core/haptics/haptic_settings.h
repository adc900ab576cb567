// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/haptics/workspace_mapping.h"
#include "core/setup/axis_mode.h"

#include <cstdint>

namespace burin {

/// How much of what the tool meets is felt. It is a choice of who plans the session: nothing else lowers it.
struct FeltCutting {
    double gain = 1.0;      ///< 1: the hardest material's reference cut gives 0.6 of the maximum force
    double friction = 0.15; ///< Coulomb's coefficient of the tool on what it slides on without cutting it
};

/// Gains and limits of one session.
struct HapticSettings {
    WorkspaceMapping mapping;
    StylusDescription stylus;     ///< whose limits bound everything that is sent
    AxisMode axis;                ///< has to fit the boundary that the tool is given
    double allowance = 0.0;       ///< mm left on the part
    double cuttingSpeed = 1000.0; ///< mm/s of the flutes' edge
    FeltCutting felt;
    double couplingShare = 0.8;     ///< of the stylus' maximum stiffness
    double guideShare = 0.6;        ///< of the stylus' maximum stiffness, for the springs of guides
    double forceShare = 0.6;        ///< of the stylus' maximum force
    double rampSeconds = 1.5;       ///< forces fade in after start and after any fault
    double tickPeriod = 0.001;      ///< s that the loop intends; later ticks count as late
    bool cutsOnButton = false;      ///< the spindle turns only while the stylus' first button is down
    std::uint32_t forceButtons = 0; ///< dead man's: forces only while one of these is held, by bit; 0: always

    /// N that are ever sent; 0 for a stylus without motors.
    double maximumForce() const noexcept { return stylus.hasMotors() ? forceShare * stylus.maximumForce.value : 0.0; }
};

} // namespace burin
