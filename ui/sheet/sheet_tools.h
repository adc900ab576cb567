// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/parsed_program.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin {

/// What a program does with one tool. Feeds mm/min, speeds 1/min.
struct ToolUse {
    double seconds = 0.0;                   ///< with accelerations and corners, without the tool change
    double leastFeed = 0.0, mostFeed = 0.0; ///< of moves that are no rapids; 0: none
    double leastSpeed = 0.0, mostSpeed = 0.0;
    double deepest = 0.0; ///< mm: lowest place of the tip over program zero, in moves that are no rapids
};

/// One for each tool, in their order. @param whole seconds of the program, tool changes included
std::vector<ToolUse> usesOf(const ParsedProgram& program, const std::vector<Tool>& tools, const MachineProfile& machine,
                            double& whole);

} // namespace burin
