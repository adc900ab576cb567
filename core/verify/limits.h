// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

namespace burin {

/// Judges travel, feeds and spindle speed of a program against the machine, and reports feed moves from an unknown
/// start.
/// @param travel limits of X, Y and Z, mm, relative to the origin of the setup frame; empty: only the length of the
/// travel is judged
/// Errors: programLimit (a pose in which the machine cannot hold the tool).
Result<void> judgeLimits(const std::vector<ToolMove>& moves, double spindleSpeed, const MachineProfile& machine,
                         const Box& travel, Findings& findings);

/// Reports rotary axes that turn beyond their limits.
void judgeRotaryAxes(const ParsedProgram& program, const MachineProfile& machine, Findings& findings);

} // namespace burin
