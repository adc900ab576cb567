// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/step_change.h"
#include "core/haptics/trace/traced_session.h"
#include "core/recording/trace_file.h"
#include "core/recording/trace_playback.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A trace together with the recorded changes of the session, ready to be played. It owns the curves of its guides, so
/// it must outlive every step that plays it.
struct SessionTrace {
    std::vector<StylusState> readings; ///< for TraceStylus
    std::vector<TimedChange> changes;  ///< in ascending order of ticks
    std::vector<std::unique_ptr<const GuideCurve>> curves;
    std::optional<TracedSession> began; ///< initial state of the session; empty for an older trace
};

/// Errors: traceInvalid (place: "line 12"; detail: what is wrong there). A trace of an older version in which a stroke
/// was undone or redone is rejected: it does not tell which of both.
Result<SessionTrace> sessionTraceOf(Trace trace, const std::string& origin);

/// A trace whose readings remain in their file, ready to be played.
struct OpenedSessionTrace {
    SessionTrace session;                    ///< without readings
    std::unique_ptr<TracePlayback> readings; ///< for TraceStylus; never null
};
/// Errors: those of openTrace and sessionTraceOf.
Result<OpenedSessionTrace> openSessionTrace(const std::filesystem::path& file);

/// Errors: those of readTrace and sessionTraceOf.
Result<SessionTrace> readSessionTrace(const std::filesystem::path& file);

} // namespace burin
