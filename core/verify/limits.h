// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

namespace burin {

/// Travel, feeds and spindle speed of a program against the machine; feed moves from nowhere.
/// @param travel ends of X, Y and Z, mm, counted from the setup frame's origin; empty: only their length is judged
/// Errors: programLimit (a pose that the machine can't hold the tool at).
Result<void> judgeLimits(const std::vector<ToolMove>& moves, double spindleSpeed, const MachineProfile& machine,
                         const Box& travel, Findings& findings);

} // namespace burin
