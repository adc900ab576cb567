// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/trace_playback.h"

#include "core/base/csv.h"
#include "core/base/file.h"
#include "core/base/ring.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace burin {

namespace {

/// Calls `use` with each line of a stream, without its line end, until `use` returns an error.
Result<void> forEachLine(std::ifstream& stream, const std::filesystem::path& file,
                         const std::function<Result<void>(std::string_view)>& use) {
    constexpr std::size_t step = 1u << 18; // bytes read at once
    std::string text;
    for (bool more = true; more;) {
        const std::size_t kept = text.size();
        text.resize(kept + step);
        errno = 0;
        stream.read(text.data() + kept, static_cast<std::streamsize>(step));
        if (stream.bad()) return readError(file, errno);
        text.resize(kept + static_cast<std::size_t>(stream.gcount()));
        more = !stream.eof();
        const std::size_t last = std::string_view(text).substr(kept).rfind('\n'); // the kept text has none
        const std::size_t end = !more ? text.size() : last == std::string_view::npos ? 0 : kept + last + 1;
        for (std::string_view rest = std::string_view(text).substr(0, end); !rest.empty();)
            if (Result<void> used = use(takeLine(rest)); !used) return used;
        text.erase(0, end);
    }
    return {};
}

class ListedReadings final : public TracePlayback {
public:
    ListedReadings(std::vector<StylusState> readings, const TraceExtent& extent)
        : TracePlayback(extent), readings_(std::move(readings)) {}

    Result<void> rewind() override {
        next_ = 0;
        return {};
    }
    bool next(StylusState& reading) noexcept override {
        if (next_ == readings_.size()) return false;
        reading = readings_[next_++];
        return true;
    }

private:
    std::vector<StylusState> readings_;
    std::size_t next_ = 0;
};

/// A separate thread reads ahead in the file.
class FiledReadings final : public TracePlayback {
public:
    FiledReadings(std::filesystem::path file, std::ifstream stream, const TraceExtent& extent)
        : TracePlayback(extent), file_(std::move(file)), stream_(std::move(stream)) {}
    ~FiledReadings() override { stop(); }
    FiledReadings(const FiledReadings&) = delete;
    FiledReadings& operator=(const FiledReadings&) = delete;

    Result<void> rewind() override {
        stop();
        stream_.clear();
        errno = 0;
        if (!stream_.seekg(0)) return readError(file_, errno);
        for (StylusState rest; ahead_.pop({&rest, 1}) > 0;) {
        } // left over from an earlier playback
        outcome_ = {};
        ended_.store(false, std::memory_order_relaxed);
        reader_ = std::jthread([this](const std::stop_token& stop) {
            outcome_ = read(stop);
            ended_.store(true, std::memory_order_release);
        });
        return {};
    }
    bool next(StylusState& reading) noexcept override {
        for (;;) {
            const bool ended = ended_.load(std::memory_order_acquire); // before looking for remaining readings
            if (ahead_.pop({&reading, 1}) > 0) return true;
            if (ended) return false;
            std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
    }
    Result<void> outcome() override {
        stop();
        const bool stopped = !outcome_ && outcome_.error().code == ErrorCode::cancelled;
        return stopped ? Result<void>() : outcome_;
    }

private:
    void stop() {
        if (!reader_.joinable()) return;
        reader_.request_stop();
        reader_.join();
    }

    Result<void> read(const std::stop_token& stop) {
        TraceParser parser(file_.string());
        std::uint64_t read = 0;
        Result<void> done = forEachLine(stream_, file_, [&](std::string_view text) -> Result<void> {
            const Result<TraceParser::Line> line = parser.take(text);
            if (!line) return line.error();
            if (!line->reading) return {};
            ++read;
            while (!ahead_.push(*line->reading)) {
                if (stop.stop_requested()) return cancelled();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return {};
        });
        if (done && read != extent().readings)
            return Error{ErrorCode::fileNotReadable, file_.string(), {}, "it was changed while it was read"};
        return done;
    }
    static Error cancelled() { return {ErrorCode::cancelled, "trace", {}, {}}; }

    static constexpr std::size_t capacity = 16384; // readings

    const std::filesystem::path file_;
    std::ifstream stream_; ///< used only by the reader while it runs
    Ring<StylusState> ahead_{capacity};
    Result<void> outcome_; ///< written by the reader until it has ended
    std::atomic<bool> ended_{false};
    std::jthread reader_; // last: it uses the above
};

} // namespace

void TraceExtent::include(const StylusState& reading) noexcept {
    if (reading.period != 0.0) ticks = true;
    if (readings > 0 && firstOutOfOrder == 0 && !(reading.time > lastTime_)) firstOutOfOrder = readings + 1;
    lastTime_ = reading.time;
    ++readings;
}

std::unique_ptr<TracePlayback> playbackOf(std::vector<StylusState> readings) {
    TraceExtent extent;
    for (const StylusState& reading : readings) extent.include(reading);
    return std::make_unique<ListedReadings>(std::move(readings), extent);
}

Result<OpenedTrace> openTrace(const std::filesystem::path& file) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(file, unknown)) { // can be read only once
        Result<Trace> trace = readTrace(file);
        if (!trace) return std::move(trace).error();
        return OpenedTrace{playbackOf(std::move(trace->readings)), std::move(trace->changes)};
    }
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    if (stream->peek() == std::ifstream::traits_type::eof()) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    TraceParser parser(file.string());
    TraceExtent extent;
    std::vector<TraceChange> changes;
    Result<void> read = forEachLine(*stream, file, [&](std::string_view text) -> Result<void> {
        Result<TraceParser::Line> line = parser.take(text);
        if (!line) return std::move(line).error();
        if (line->reading) extent.include(*line->reading);
        if (line->change) changes.push_back(std::move(*line->change));
        return {};
    });
    if (read) read = parser.end();
    if (!read) return std::move(read).error();
    return OpenedTrace{std::make_unique<FiledReadings>(file, std::move(*stream), extent), std::move(changes)};
}

} // namespace burin
