// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_step.h"
#include "core/haptics/tick_sink.h"
#include "core/haptics/traced_session.h"
#include "core/recording/trace_file.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A trace with what the session was told while it was recorded, ready to be played. It owns the curves of its guides,
/// so it outlives every step that plays it.
struct SessionTrace {
    std::vector<StylusState> readings; ///< for TraceStylus
    std::vector<TimedChange> changes;  ///< rising
    std::vector<std::unique_ptr<const GuideCurve>> curves;
    std::optional<TracedSession> began; ///< with what it began; none in an older trace
};

/// Errors: traceInvalid (place: "line 12"; detail: what is wrong there). A session in which the workpiece was changed
/// beside the milling (a stroke taken back, another state put in place) is refused: a trace does not hold that state.
Result<SessionTrace> sessionTraceOf(Trace trace, const std::string& origin);

/// Errors: those of readTrace and sessionTraceOf.
Result<SessionTrace> readSessionTrace(const std::filesystem::path& file);

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
