// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/replayed_changes.h"

namespace burin {

AtEdge ReplayedChanges::edge() noexcept {
    const AtEdge answer = next_.edge();
    if (answer != AtEdge::tick) return answer;
    while (!changes_.empty() && changes_.front().tick <= ticks_) {
        step_.apply(changes_.front().change);
        changes_ = changes_.subspan(1);
    }
    return answer;
}

void ReplayedChanges::tick(const Sample& sample, const TickTiming& timing) noexcept {
    ++ticks_;
    next_.tick(sample, timing);
}

} // namespace burin
