// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/replayed_changes.h"

#include <variant>

namespace burin {

AtEdge ReplayedChanges::edge() noexcept {
    const AtEdge answer = next_.edge();
    if (answer != AtEdge::tick) return answer;
    for (; due(); changes_ = changes_.subspan(1)) {
        const auto* const workpiece = std::get_if<WorkpieceChange>(&changes_.front().change);
        if (workpiece == nullptr) {
            step_.apply(changes_.front().change);
            continue;
        }
        if (wait_.load(std::memory_order_acquire) != Wait::made) {
            wait_.store(workpiece->undone ? Wait::undo : Wait::redo, std::memory_order_release);
            return AtEdge::stand;
        }
        wait_.store(Wait::nothing, std::memory_order_relaxed);
    }
    return answer;
}

std::optional<WorkpieceChange> ReplayedChanges::awaited(bool loopEnded) noexcept {
    if (!loopEnded) {
        const Wait wait = wait_.load(std::memory_order_acquire);
        if (wait == Wait::undo || wait == Wait::redo) return WorkpieceChange{wait == Wait::undo};
        return std::nullopt;
    }
    if (wait_.exchange(Wait::nothing, std::memory_order_relaxed) == Wait::made) changes_ = changes_.subspan(1);
    for (; due(); changes_ = changes_.subspan(1))
        if (const auto* const workpiece = std::get_if<WorkpieceChange>(&changes_.front().change)) return *workpiece;
    return std::nullopt;
}

void ReplayedChanges::made(bool loopEnded) noexcept {
    if (loopEnded)
        changes_ = changes_.subspan(1);
    else
        wait_.store(Wait::made, std::memory_order_release);
}

void ReplayedChanges::tick(const Sample& sample, const TickTiming& timing) noexcept {
    ++ticks_;
    next_.tick(sample, timing);
}

} // namespace burin
