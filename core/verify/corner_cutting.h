// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

#include <span>

namespace burin {

/// Judges the corners that a program lets its control cut (LinuxCNC's G64). Each is the parabola that deviates from the
/// corner by the stated tolerance or, without one, begins and ends in the middle of the adjacent blocks. Where the tool
/// on it enters the part deeper than the tolerance for gouges, or leaves more than `request.excessTolerance` of stock
/// in a corner at the part, the line of the G64 gets a finding, with the number of such corners. Deviations from the
/// path of no more than the tolerance for gouges are not judged. Lines whose ends are all within Q of one line (P if
/// there is no Q) are judged as that line.
/// @param tools indexed by ToolMove::tool. Errors: cancelled.
Result<void> judgeCorners(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request,
                          Findings& findings, const Progress& progress);

} // namespace burin
