// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

#include <span>

namespace burin {

/// Reports where a move, rapids too, takes flutes, shank or holder into an obstacle that is on, by more than the
/// tolerance for gouges. The obstacle itself counts; the margin that the hand keeps from it is not judged.
/// @param tools those that ToolMove::tool counts. Errors: cancelled.
Result<void> judgeObstacles(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                            const VerifyRequest& request, Findings& findings, const Progress& progress);

} // namespace burin
