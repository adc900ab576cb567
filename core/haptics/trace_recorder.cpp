// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace_recorder.h"

#include "core/base/file.h"
#include "core/recording/trace_file.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

namespace burin {

namespace {
constexpr std::chrono::milliseconds interval{50}; // between two looks at the ring
}

Result<std::unique_ptr<TraceRecorder>> TraceRecorder::begin(const std::filesystem::path& file, TickSink& next) {
    std::unique_ptr<TraceRecorder> recorder(new TraceRecorder(file, temporaryBeside(file), next));
    if (!recorder->out_) return writeError(file, errno);
    return recorder;
}

TraceRecorder::TraceRecorder(std::filesystem::path file, std::filesystem::path beside, TickSink& next)
    : file_(std::move(file)), beside_(std::move(beside)), next_(next), out_(beside_, std::ios::binary) {
    if (!out_) return;
    out_ << tickTraceHeader << '\n';
    thread_ = std::jthread([this](const std::stop_token& stop) { write(stop); });
}

TraceRecorder::~TraceRecorder() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(beside_, ignored);
}

AtEdge TraceRecorder::edge() noexcept {
    const AtEdge answer = next_.edge();
    return answer == AtEdge::tick && readings_.size() == readings_.capacity() ? AtEdge::full : answer;
}

void TraceRecorder::tick(const Sample& sample, const TickTiming& timing) noexcept {
    StylusState reading = timing.reading;
    reading.time = sample.time;
    // 0 would be "not told"; to a tick it is as much a fault as any other that is not above 0.
    reading.period = timing.period != 0.0 ? timing.period : -1.0;
    readings_.push(reading); // room was seen at the edge
    next_.tick(sample, timing);
}

void TraceRecorder::write(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        writeWaiting();
        woken_.wait_for(lock, stop, interval, [] { return false; });
    }
    writeWaiting();
}

void TraceRecorder::writeWaiting() {
    std::array<StylusState, 256> batch;
    while (const std::size_t count = readings_.pop(batch)) {
        text_.clear();
        for (std::size_t i = 0; i < count; ++i) appendTick(text_, batch[i]);
        out_ << text_;
    }
}

Result<void> TraceRecorder::finish() {
    thread_.request_stop();
    thread_.join();
    errno = 0;
    out_.close();
    if (out_) return replaceFile(beside_, file_);
    const int systemError = errno;
    std::error_code ignored;
    std::filesystem::remove(beside_, ignored);
    return writeError(file_, systemError);
}

} // namespace burin
