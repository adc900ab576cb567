// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/haptics/trace/session_trace.h"

#include <cstddef>
#include <span>

namespace burin {

/// Applies to a step, at each edge, the changes that were recorded there in its trace. It has to precede every other
/// sink that changes the step at its edge, as the recorder of the trace did.
class ReplayedChanges final : public TickSink {
public:
    /// @param trace, step, next must outlive the object
    ReplayedChanges(const SessionTrace& trace, HapticStep& step, TickSink& next) noexcept
        : changes_(trace.changes), step_(step), next_(next) {}

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

private:
    std::span<const TimedChange> changes_; ///< changes that are still to be applied
    HapticStep& step_;
    TickSink& next_;
    std::size_t ticks_ = 0;
};

} // namespace burin
