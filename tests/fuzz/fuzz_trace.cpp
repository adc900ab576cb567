// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/session_trace.h"
#include "core/haptics/trace/step_change_text.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace burin;

/// A trace that was read is written and read again: both texts must be the same.
void comesBack(const SessionTrace& session) {
    StepChangeWriter writer;
    std::string written;
    for (const TimedChange& change : session.changes) writer.append(written, "", change.change);
    StepChangeReader reader;
    StepChangeWriter again;
    std::string twice;
    for (std::string_view rest = written; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        const auto change = reader.read(rest.substr(0, end), "fuzz");
        if (!change) std::abort();
        if (*change) again.append(twice, "", **change);
        rest.remove_prefix(end + 1);
    }
    if (written != twice) std::abort();
    if (!session.began) return;
    const std::string began = formatTracedSession(*session.began);
    const auto read = readTracedSession(began, "fuzz");
    if (!read || formatTracedSession(*read) != began) std::abort();
}

} // namespace

/// With any trace, reading ends; its content is restored to the bit.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    Result<Trace> trace = parseTrace(text, "fuzz");
    if (!trace) return 0;
    for (const StylusState& state : trace->readings)
        if (!isFinite(state.pose.position)) std::abort();
    const std::string readings = formatTrace(trace->readings);
    const Result<Trace> again = parseTrace(readings, "fuzz");
    if (again && formatTrace(again->readings) != readings) std::abort();
    const Result<SessionTrace> session = sessionTraceOf(std::move(*trace), "fuzz");
    if (session) comesBack(*session);
    return 0;
}
