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

/// Writes every reading of a loop, with the period that its tick was told, and what its step is told between them, to a
/// trace of ticks (trace_file.h) while the loop runs; the sink behind it goes on as without it. The file is complete
/// with `finish`, and put in its place by whoever gets it. A ring that is full is told to the loop as any full sink is:
/// nothing is left out.
class TraceRecorder final : public TickSink, public StepChangeListener {
public:
    /// The step whose changes are to be kept listens to it (HapticStep::listen). Curves of guides outlive `finish`.
    /// @param next outlives the recorder. Errors: fileNotWritable.
    /// @param session with what it begins; where it is not told, whoever plays the trace has to know it
    static Result<std::unique_ptr<TraceRecorder>> begin(const std::filesystem::path& file, TickSink& next,
                                                        const std::optional<TracedSession>& session = std::nullopt);
    ~TraceRecorder() override; ///< without `finish`: the file is removed
    TraceRecorder(const TraceRecorder&) = delete;
    TraceRecorder& operator=(const TraceRecorder&) = delete;

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;
    void changed(const StepChange& change) noexcept override;

    /// The complete trace. Owner's thread, once no tick runs any more, once. Errors: fileNotWritable, diskFull.
    Result<StagedFile> finish();

private:
    TraceRecorder(StagedFile file, TickSink& next, const std::optional<TracedSession>& session);
    void write(const std::stop_token& stop);
    void writeWaiting();
    void appendChangesBefore(std::size_t reading);

    static constexpr std::size_t capacity = 16384;     ///< s of ticks that the disk may keep us waiting for
    static constexpr std::size_t changeCapacity = 256; ///< that come in a moment

    StagedFile file_; ///< the writer's until it ended
    TickSink& next_;
    Ring<StylusState> readings_{capacity};
    Ring<TimedChange> changes_{changeCapacity};
    std::size_t read_ = 0;    ///< readings; the loop's
    bool changeLost_ = false; ///< the loop's
    std::size_t written_ = 0; ///< readings; the rest the writer's
    std::vector<TimedChange> waiting_;
    StepChangeWriter words_;
    std::string text_;
    Result<void> outcome_; ///< the writer's until it ended
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_; // last: it uses the above
};

} // namespace burin
