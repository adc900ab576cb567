// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// The properties of a path on which its position in a program depends.
struct ToolPass {
    std::string toolId;
    double diameter = 0.0;  ///< mm, of its flutes
    double allowance = 0.0; ///< mm of stock that the path leaves on the part; more than 0: roughing
};

/// Why a path has its position in the order.
enum class OrderReason : std::uint8_t {
    first,
    sameTool,            ///< as the one before: no tool change
    smallerTool,         ///< larger tools come first
    finishingAfterRough, ///< all roughing comes first
    lessAllowance,       ///< the same tool, less allowance
    asGiven,             ///< nothing distinguishes them but the given order
};
struct OrderedPass {
    std::size_t pass = 0; ///< index in the given passes
    OrderReason reason = OrderReason::first;
};

/// A sensible order for several tools in one program: roughing before finishing, larger tools before smaller ones, more
/// allowance before less, and among tools of one size passes of the same tool together, beginning with the tool that is
/// in the spindle already: no order that obeys the first two rules has fewer tool changes. Otherwise as given.
std::vector<OrderedPass> orderPasses(std::span<const ToolPass> passes);

} // namespace burin
