// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/haptics/trace/session_trace.h"

#include <cstddef>
#include <span>

namespace burin {

/// Tells a step at each edge what it was told there when its trace was recorded. Stands before every other sink whose
/// edge tells the step something, as the recorder of the trace did.
class ReplayedChanges final : public TickSink {
public:
    /// @param trace, step, next outlive the object
    ReplayedChanges(const SessionTrace& trace, HapticStep& step, TickSink& next) noexcept
        : changes_(trace.changes), step_(step), next_(next) {}

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

private:
    std::span<const TimedChange> changes_; ///< that are still to come
    HapticStep& step_;
    TickSink& next_;
    std::size_t ticks_ = 0;
};

} // namespace burin
