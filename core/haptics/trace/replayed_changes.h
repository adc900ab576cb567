// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/haptics/trace/session_trace.h"

#include <atomic>
#include <cstddef>
#include <optional>
#include <span>

namespace burin {

/// Applies to a step, at each edge, the changes that were recorded there in its trace. It has to precede every other
/// sink that changes the step at its edge, as the recorder of the trace did.
///
/// A stroke is undone and redone by the owner of the workpiece, as when it was recorded: the loop stands until the
/// owner has done so (`awaited`, `made`).
class ReplayedChanges final : public TickSink {
public:
    /// @param trace, step, next must outlive the object
    ReplayedChanges(const SessionTrace& trace, HapticStep& step, TickSink& next) noexcept
        : changes_(trace.changes), step_(step), next_(next) {}

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

    /// The change of the workpiece that the loop waits for, or that follows its last tick. Owner's thread.
    /// @param loopEnded whether the loop has ended: the changes then belong to the owner
    std::optional<WorkpieceChange> awaited(bool loopEnded) noexcept;
    /// Called once the owner has made the awaited change. Owner's thread.
    void made(bool loopEnded) noexcept;
    /// Number of ticks so far. Owner's thread, while the loop waits or after it has ended.
    std::size_t ticks() const noexcept { return ticks_; }

private:
    enum class Wait : std::uint8_t { nothing, undo, redo, made };
    bool due() const noexcept { return !changes_.empty() && changes_.front().tick <= ticks_; }

    std::span<const TimedChange> changes_; ///< changes that are still to be applied
    HapticStep& step_;
    TickSink& next_;
    std::size_t ticks_ = 0;
    std::atomic<Wait> wait_{Wait::nothing};
};

} // namespace burin
