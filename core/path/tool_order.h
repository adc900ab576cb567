// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// What the order of a program's paths depends on.
struct ToolPass {
    std::string toolId;
    double diameter = 0.0;  ///< mm, of its flutes
    double allowance = 0.0; ///< mm that the path leaves on the part; more than 0: roughing
};

/// Why a path has the place that it has.
enum class OrderReason : std::uint8_t {
    first,
    sameTool,            ///< as the one before: no change
    smallerTool,         ///< larger tools come first
    finishingAfterRough, ///< all roughing comes first
    lessAllowance,       ///< the same tool, nearer to the part
    asGiven,             ///< nothing tells them apart but the order that they were given in
};
struct OrderedPass {
    std::size_t pass = 0; ///< index of what was given
    OrderReason reason = OrderReason::first;
};

/// A sensible order for several tools in one program: roughing before finishing, larger tools before smaller ones, more
/// allowance before less, and among tools of one size those together that are the same, beginning with the one that is
/// in the spindle already: no order that keeps the first two has fewer changes of tool. Otherwise as given.
std::vector<OrderedPass> orderPasses(std::span<const ToolPass> passes);

} // namespace burin
