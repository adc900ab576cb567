// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/kept_dips.h"
#include "core/verify/tool_moves.h"
#include "core/verify/verify.h"

#include <map>
#include <span>
#include <tuple>

namespace burin {

/// Collects near passes. A holder may pass the same wall on a thousand lines: of all passes of one section along one
/// neighbour within `nearPlace` of the nearest one, only that one is reported, with the number of lines.
class NearPasses {
public:
    void add(const NearPass& pass);
    /// The nearest first.
    std::vector<NearPass> byPlace() const;

private:
    std::map<std::tuple<std::uint32_t, ToolSection, NearTo>, NearPass> nearest_;
};

/// Finds where shank or holder pass the part, or an obstacle that is switched on, closer than `request.nearDistance`,
/// and no deeper in it than the tolerance for gouges; deeper ones are findings. Examined every `request.sampling` of
/// every move, more closely where a corner may be cut. Near passes of the stock are reported by `replay`.
/// @param tools indexed by ToolMove::tool @param numbers of the moves (KnownMoves) @param kept of judgements with the
/// same tools, part, obstacles and distance; the result does not depend on it
/// Errors: cancelled.
Result<void> judgeNearPasses(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                             const VerifyRequest& request, std::span<const std::uint32_t> numbers, KeptDips& kept,
                             NearPasses& passes, const Progress& progress);

} // namespace burin
