// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/tool_order.h"

#include <algorithm>
#include <numeric>

namespace burin {
namespace {

bool roughs(const ToolPass& pass) noexcept {
    return pass.allowance > 0.0;
}

/// Whether no rule puts either of them first.
bool isSameRank(const ToolPass& a, const ToolPass& b) noexcept {
    return roughs(a) == roughs(b) && a.diameter == b.diameter;
}

/// Groups the passes of one rank by tool, in the order in which tools occur, except that the tool in the spindle comes
/// first and a tool that the next rank uses as well comes last, so that the next rank may begin with it.
class Rank {
public:
    Rank(std::span<const ToolPass> passes, std::span<std::size_t> order) : passes_(passes), order_(order) {
        for (const std::size_t pass : order_)
            if (std::ranges::find(tools_, passes_[pass].toolId) == tools_.end()) tools_.push_back(passes_[pass].toolId);
    }

    bool has(const std::string& tool) const { return std::ranges::find(tools_, tool) != tools_.end(); }

    /// @return the tool in the spindle after it
    std::string arrange(const std::string& inSpindle, const Rank* next) {
        const auto first = std::ranges::find(tools_, inSpindle);
        const bool begins = first != tools_.end();
        if (begins) std::rotate(tools_.begin(), first, first + 1);
        const auto shared = std::find_if(tools_.begin() + (begins && tools_.size() > 1 ? 1 : 0), tools_.end(),
                                         [&](const std::string& tool) { return next != nullptr && next->has(tool); });
        if (shared != tools_.end()) std::rotate(shared, shared + 1, tools_.end());
        std::ranges::stable_sort(order_, {}, [&](std::size_t pass) {
            return std::ranges::find(tools_, passes_[pass].toolId) - tools_.begin();
        });
        return tools_.back();
    }

private:
    std::span<const ToolPass> passes_;
    std::span<std::size_t> order_;
    std::vector<std::string> tools_;
};

OrderReason reasonOf(const ToolPass& before, const ToolPass& pass) {
    if (roughs(before) && !roughs(pass)) return OrderReason::finishingAfterRough;
    if (before.diameter > pass.diameter) return OrderReason::smallerTool;
    if (before.toolId != pass.toolId) return OrderReason::asGiven;
    return before.allowance > pass.allowance ? OrderReason::lessAllowance : OrderReason::sameTool;
}

} // namespace

std::vector<OrderedPass> orderPasses(std::span<const ToolPass> passes) {
    std::vector<std::size_t> order(passes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const ToolPass &one = passes[a], &other = passes[b];
        if (roughs(one) != roughs(other)) return roughs(one);
        if (one.diameter != other.diameter) return one.diameter > other.diameter;
        return one.allowance > other.allowance;
    });
    std::vector<Rank> ranks;
    for (std::size_t from = 0, end = 0; from < order.size(); from = end) {
        for (end = from + 1; end < order.size() && isSameRank(passes[order[from]], passes[order[end]]);) ++end;
        ranks.emplace_back(passes, std::span(order).subspan(from, end - from));
    }
    std::string inSpindle;
    for (std::size_t i = 0; i < ranks.size(); ++i)
        inSpindle = ranks[i].arrange(inSpindle, i + 1 < ranks.size() ? &ranks[i + 1] : nullptr);
    std::vector<OrderedPass> ordered;
    for (std::size_t i = 0; i < order.size(); ++i)
        ordered.push_back({order[i], i == 0 ? OrderReason::first : reasonOf(passes[order[i - 1]], passes[order[i]])});
    return ordered;
}

} // namespace burin
