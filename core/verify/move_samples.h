// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/tool_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace burin {

/// Consecutively numbered samples along moves: both ends of every move whose end is known, and points at most
/// `sampling` mm apart between them. The point where one move ends and the next begins counts once.
class MoveSamples {
public:
    MoveSamples(const std::vector<ToolMove>& moves, double sampling) : moves_(moves), first_{0} {
        first_.reserve(moves.size() + 1);
        for (const ToolMove& move : moves) {
            const double steps = std::max(1.0, std::ceil(glm::length(move.to.tip - move.begin().tip) / sampling));
            const std::size_t start = first_.back() == 0 ? 1 : 0; // the first sample of all
            first_.push_back(first_.back() + (move.endKnown ? static_cast<std::size_t>(steps) + start : 0));
        }
    }

    std::size_t count() const noexcept { return first_.back(); }
    /// Number of the first sample of a move; of the move after the last one: `count`.
    std::size_t firstOf(std::size_t move) const noexcept { return first_[move]; }
    /// Index of the move with a sample, which must exist.
    std::size_t moveOf(std::size_t sample) const noexcept {
        return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), sample) - first_.begin()) - 1;
    }

    /// Calls `visit(index of the move, pose)` for samples `first` … `end` - 1.
    template <class Visit>
    void forEach(std::size_t first, std::size_t end, const Visit& visit) const {
        if (first >= end) return;
        std::size_t at = moveOf(first);
        for (std::size_t i = first; i < end; ++i) {
            while (i >= first_[at + 1]) ++at;
            const ToolMove& move = moves_[at];
            const std::size_t begins = first_[at] == 0 ? 0 : 1, steps = first_[at + 1] - first_[at] - 1 + begins;
            const double share = static_cast<double>(i - first_[at] + begins) / static_cast<double>(steps);
            visit(static_cast<std::uint32_t>(at), share < 1.0 ? move.poseAt(share) : move.to);
        }
    }

private:
    const std::vector<ToolMove>& moves_;
    std::vector<std::size_t> first_; ///< by move, the number of its first sample
};

} // namespace burin
