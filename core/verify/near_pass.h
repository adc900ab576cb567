// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/tool_moves.h"
#include "core/verify/verify.h"

#include <map>
#include <span>
#include <tuple>

namespace burin {

/// Collects near passes. A holder may pass one wall on a thousand lines: of all that one section passes one neighbour
/// by within `nearPlace` of where it is nearest, only that one is told, with the number of lines.
class NearPasses {
public:
    void add(const NearPass& pass);
    /// The nearest first.
    std::vector<NearPass> byPlace() const;

private:
    std::map<std::tuple<std::uint32_t, ToolSection, NearTo>, NearPass> nearest_;
};

/// Where shank or holder pass the part or an obstacle that is on nearer than `request.nearDistance`, and no deeper in
/// it than the tolerance for gouges: deeper is a finding. Looked at every `request.sampling` of every move, closer
/// where a corner may be cut. What passes the stock is told by `replay`.
/// @param tools those that ToolMove::tool counts. Errors: cancelled.
Result<void> judgeNearPasses(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                             const VerifyRequest& request, NearPasses& passes, const Progress& progress);

} // namespace burin
