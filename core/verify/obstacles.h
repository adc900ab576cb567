// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/kept_dips.h"
#include "core/verify/tool_moves.h"

#include <span>

namespace burin {

/// Reports moves, rapids too, on which flutes, shank or holder enter an obstacle that is switched on by more than the
/// tolerance for gouges. Only the obstacle itself counts; the margin that the hand keeps from it is not judged.
/// @param tools indexed by ToolMove::tool @param numbers of the moves (KnownMoves) @param kept of judgements with the
/// same tools, obstacles and tolerance; the result does not depend on it
/// Errors: cancelled.
Result<void> judgeObstacles(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                            const VerifyRequest& request, std::span<const std::uint32_t> numbers, KeptDips& kept,
                            Findings& findings, const Progress& progress);

} // namespace burin
