// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/session_trace.h"

#include "core/haptics/trace/step_change_text.h"

#include <utility>

namespace burin {

Result<SessionTrace> sessionTraceOf(Trace trace, const std::string& origin) {
    SessionTrace session;
    session.readings = std::move(trace.readings);
    StepChangeReader reader;
    for (const TraceChange& line : trace.changes) {
        const auto invalid = [&](std::string detail) {
            return Error{ErrorCode::traceInvalid, origin, "line " + std::to_string(line.line), std::move(detail)};
        };
        const auto wrong = [&](const Error& error) {
            return invalid(error.place + (error.place.empty() ? "" : ": ") + error.detail);
        };
        if (tellsTracedSession(line.text)) {
            Result<TracedSession> began = readTracedSession(line.text, origin);
            if (!began) return wrong(began.error());
            if (session.began || line.reading > 0) return invalid("a session begins once, before its first reading");
            session.began = std::move(*began);
            continue;
        }
        const Result<std::optional<StepChange>> change = reader.read(line.text, origin);
        if (!change) return wrong(change.error());
        if (!*change) continue;
        session.changes.push_back({line.reading, **change});
    }
    session.curves = reader.takeCurves();
    return session;
}

Result<OpenedSessionTrace> openSessionTrace(const std::filesystem::path& file) {
    Result<OpenedTrace> trace = openTrace(file);
    if (!trace) return std::move(trace).error();
    Result<SessionTrace> session = sessionTraceOf({{}, std::move(trace->changes)}, file.string());
    if (!session) return std::move(session).error();
    return OpenedSessionTrace{std::move(*session), std::move(trace->readings)};
}

Result<SessionTrace> readSessionTrace(const std::filesystem::path& file) {
    Result<Trace> trace = readTrace(file);
    if (!trace) return std::move(trace).error();
    return sessionTraceOf(std::move(*trace), file.string());
}

} // namespace burin
