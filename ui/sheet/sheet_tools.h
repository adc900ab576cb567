// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/parsed_program.h"
#include "core/tool/tool.h"

#include <limits>
#include <vector>

namespace burin {

/// How a program uses one tool. Feeds mm/min, speeds 1/min.
struct ToolUse {
    double seconds = 0.0;                   ///< with accelerations and corners, without the tool change
    double leastFeed = 0.0, mostFeed = 0.0; ///< of moves that are no rapids; 0: none
    double leastSpeed = 0.0, mostSpeed = 0.0;
    /// mm: lowest tip position relative to program zero, in moves that are no rapids; infinite: there are none
    double deepest = std::numeric_limits<double>::infinity();
};

/// The time of a program, and its tools.
struct ProgramUse {
    double seconds = 0.0;       ///< tool changes included
    std::vector<ToolUse> tools; ///< one for each tool, in their order
};
ProgramUse useOf(const ParsedProgram& program, const std::vector<Tool>& tools, const MachineProfile& machine);

} // namespace burin
