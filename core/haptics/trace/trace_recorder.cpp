// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/trace_recorder.h"

#include "core/recording/trace_file.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <utility>

namespace burin {

namespace {
constexpr std::chrono::milliseconds interval{50}; // between two checks of the ring
}

Error traceEnded(const Error& error) {
    if (error.code == ErrorCode::traceEnded) return error;
    const bool full = error.code == ErrorCode::diskFull;
    return {ErrorCode::traceEnded, error.subject, {}, full ? "the disk is full" : error.detail};
}

Result<std::unique_ptr<TraceRecorder>> TraceRecorder::begin(const std::filesystem::path& file, TickSink& next,
                                                            const std::optional<TracedSession>& session,
                                                            IfFull ifFull) {
    Result<StagedFile> staged = StagedFile::begin(file);
    if (!staged) return std::move(staged).error();
    return std::unique_ptr<TraceRecorder>(new TraceRecorder(std::move(*staged), next, session, ifFull));
}

TraceRecorder::TraceRecorder(StagedFile file, TickSink& next, const std::optional<TracedSession>& session,
                             IfFull ifFull)
    : file_(std::move(file)), next_(next), ifFull_(ifFull) {
    text_.append(tickTraceMark).append("\n").append(tickTraceHeader).append("\n");
    if (session) text_.append(1, changeMark).append(formatTracedSession(*session)).append("\n");
    note(file_.append(text_));
    thread_ = std::jthread([this](const std::stop_token& stop) { write(stop); });
}

TraceRecorder::~TraceRecorder() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

AtEdge TraceRecorder::edge() noexcept {
    const AtEdge answer = next_.edge();
    const bool full = readings_.size() == readings_.capacity() || changeLost_;
    if (answer != AtEdge::tick || !full || overrun_.load(std::memory_order_relaxed)) return answer;
    if (ifFull_ == IfFull::endsLoop) return AtEdge::full;
    overrun_.store(true, std::memory_order_relaxed);
    return answer;
}

void TraceRecorder::changed(const StepChange& change) noexcept {
    if (overrun_.load(std::memory_order_relaxed)) return;
    // A change that finds no room ends the loop or the trace at the next edge: a trace without it would replay a
    // different session.
    if (!changes_.push({read_, change})) changeLost_ = true;
}

void TraceRecorder::tick(const Sample& sample, const TickTiming& timing) noexcept {
    StylusState reading = timing.reading;
    reading.time = sample.time;
    // 0 would mean "not specified"; any period that is not above 0 is the same fault to a tick.
    reading.period = timing.period != 0.0 ? timing.period : -1.0;
    if (!overrun_.load(std::memory_order_relaxed)) {
        readings_.push(reading); // the edge has checked that there is room
        ++read_;
    }
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
        for (std::size_t i = 0; i < count; ++i) {
            appendChangesBefore(written_++);
            appendTick(text_, batch[i]);
        }
        if (outcome_) note(file_.append(text_)); // after an error the remaining data is of no use
    }
    if (outcome_ && overrun_.load(std::memory_order_relaxed))
        note(Error{ErrorCode::traceEnded, file_.file().string(), {}, "the disk could not keep up"});
}

void TraceRecorder::note(Result<void> outcome) {
    outcome_ = std::move(outcome);
    if (!outcome_) failing_.store(true, std::memory_order_release);
}

Error TraceRecorder::fault() const {
    return traceEnded(outcome_.error());
}

/// Changes made before a reading are in their ring before the reading is.
void TraceRecorder::appendChangesBefore(std::size_t reading) {
    const std::size_t before = waiting_.size();
    waiting_.resize(before + changes_.size());
    changes_.pop(std::span(waiting_).subspan(before));
    const auto later = std::ranges::find_if(waiting_, [=](const TimedChange& one) { return one.tick > reading; });
    for (auto change = waiting_.begin(); change != later; ++change)
        words_.append(text_, std::string_view(&changeMark, 1), change->change);
    waiting_.erase(waiting_.begin(), later);
}

Result<StagedFile> TraceRecorder::finish() {
    thread_.request_stop();
    thread_.join();
    text_.clear();
    appendChangesBefore(std::numeric_limits<std::size_t>::max()); // what was changed after the last reading
    if (outcome_) note(file_.append(text_));
    if (outcome_) note(file_.flush());
    if (!outcome_) return outcome_.error();
    return std::move(file_);
}

} // namespace burin
