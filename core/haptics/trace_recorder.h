// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/ring.h"
#include "core/haptics/tick_sink.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>

namespace burin {

/// Writes every reading of a loop, with the period that its tick was told, to a trace of ticks (trace_file.h) while the
/// loop runs; the sink behind it goes on as without it. The file appears, whole, with `finish`. A ring that is full is
/// told to the loop as any full sink is: nothing is left out.
class TraceRecorder final : public TickSink {
public:
    /// @param next outlives the recorder. Errors: fileNotWritable.
    static Result<std::unique_ptr<TraceRecorder>> begin(const std::filesystem::path& file, TickSink& next);
    ~TraceRecorder() override; ///< without `finish`: the file is not written
    TraceRecorder(const TraceRecorder&) = delete;
    TraceRecorder& operator=(const TraceRecorder&) = delete;

    AtEdge edge() noexcept override;
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;

    /// Owner's thread, once no tick runs any more. Errors: fileNotWritable, diskFull.
    Result<void> finish();

private:
    TraceRecorder(std::filesystem::path file, std::filesystem::path beside, TickSink& next);
    void write(const std::stop_token& stop);
    void writeWaiting();

    static constexpr std::size_t capacity = 16384; ///< s of ticks that the disk may keep us waiting for

    const std::filesystem::path file_, beside_;
    TickSink& next_;
    Ring<StylusState> readings_{capacity};
    std::ofstream out_;
    std::string text_;
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_; // last: it uses the above
};

} // namespace burin
