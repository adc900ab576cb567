// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

#include <span>

namespace burin {

/// The corners that a program lets its control cut (LinuxCNC's G64): each as the parabola that leaves it by the
/// tolerance stated, or, without one, begins and ends in the middle of the blocks that meet there. Where the tool is
/// deeper in the part on it than the tolerance for gouges, or leaves a corner at the part by more than
/// `request.excessTolerance` of stock, the line of the G64 has a finding, with the number of such corners. What leaves
/// the path by no more than the tolerance for gouges is not judged. Lines that lie within Q of one line (P where no Q
/// stands) are that line.
/// @param tools those that ToolMove::tool counts. Errors: cancelled.
Result<void> judgeCorners(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request,
                          Findings& findings, const Progress& progress);

} // namespace burin
