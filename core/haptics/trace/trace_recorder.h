// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/ring.h"
#include "core/base/staged_file.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/haptics/trace/step_change_text.h"
#include "core/haptics/trace/traced_session.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace burin {

/// The same error for a trace that is not required: milling goes on. @param error of writing it
Error traceEnded(const Error& error);

/// Writes every reading of a loop, with the period passed to its tick, and the changes of its step between them, to a
/// trace of ticks (trace_file.h) while the loop runs; all calls are passed on to the next sink unchanged. The file is
/// complete after `finish`; the caller of `finish` moves it to its final path. Nothing is omitted: where the file can't
/// be written in time, either the loop ends, as with any full sink, or the trace does.
class TraceRecorder final : public TickSink, public StepChangeListener {
public:
    /// The recorder has to be set as the listener of the step whose changes are recorded (HapticStep::listen). Curves
    /// of guides must outlive `finish`.
    enum class IfFull : std::uint8_t {
        endsLoop,  ///< a full ring is reported to the loop
        endsTrace, ///< recording stops, `failing` says so, and the loop goes on
    };
    /// @param next must outlive the recorder. Errors: fileNotWritable.
    /// @param session initial state of the session; if it is not given, it has to be known when the trace is played
    static Result<std::unique_ptr<TraceRecorder>> begin(const std::filesystem::path& file, TickSink& next,
                                                        const std::optional<TracedSession>& session = std::nullopt,
                                                        IfFull ifFull = IfFull::endsLoop);
    ~TraceRecorder() override; ///< without a call of `finish` the file is removed
    TraceRecorder(const TraceRecorder&) = delete;
    TraceRecorder& operator=(const TraceRecorder&) = delete;

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;
    void changed(const StepChange& change) noexcept override;

    /// Whether the trace is incomplete for ever; `finish` then returns the error. Any thread.
    bool failing() const noexcept { return failing_.load(std::memory_order_acquire); }
    /// Why a trace is failing, before `finish`. Owner's thread.
    Error fault() const;

    /// Returns the complete trace. Owner's thread, once no more ticks run; called once. Errors: fileNotWritable,
    /// diskFull, traceEnded (the disk could not keep up).
    Result<StagedFile> finish();

private:
    TraceRecorder(StagedFile file, TickSink& next, const std::optional<TracedSession>& session, IfFull ifFull);
    void write(const std::stop_token& stop);
    void writeWaiting();
    void appendChangesBefore(std::size_t reading);
    void note(Result<void> outcome);

    static constexpr std::size_t capacity = 16384;     ///< ticks: about 16 s at 1 kHz during which the disk may be slow
    static constexpr std::size_t changeCapacity = 256; ///< changes that may be made at about the same time

    StagedFile file_; ///< belongs to the writer until it ended
    TickSink& next_;
    Ring<StylusState> readings_{capacity};
    Ring<TimedChange> changes_{changeCapacity};
    std::size_t read_ = 0;    ///< number of readings; belongs to the loop
    bool changeLost_ = false; ///< belongs to the loop
    const IfFull ifFull_;
    std::atomic<bool> overrun_{false}; ///< set by the loop, which then no longer records
    std::atomic<bool> failing_{false}; ///< set after the error in `outcome_`, which does not change any more
    std::size_t written_ = 0;          ///< number of readings; this member and the following belong to the writer
    std::vector<TimedChange> waiting_;
    StepChangeWriter words_;
    std::string text_;
    Result<void> outcome_; ///< belongs to the writer until it ended
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_; // last: it uses the members above
};

} // namespace burin
