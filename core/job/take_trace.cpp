// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/take_trace.h"

#include "core/base/staged_file.h"
#include "core/haptics/trace/step_change_text.h"
#include "core/recording/take_csv.h"
#include "core/recording/trace_file.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace burin {
namespace {

bool cutsIn(const Sample& sample) noexcept {
    return (sample.flags & sampleSpindleOff) == 0;
}

/// Samples that do not count.
struct TracedInterval {
    SampleRange samples;
    std::size_t strokes = 0; ///< that begin in it, and are undone at its end
    bool withinOne = false;  ///< it begins within a stroke
};

/// What a trace has to say besides the readings.
class TakeOutlook {
public:
    explicit TakeOutlook(const TakeOutline& take) {
        for (const SampleRange& range : take.undone) intervals_.push_back({range});
    }
    void add(std::span<const Sample> samples) noexcept {
        for (const Sample& sample : samples) add(sample);
    }
    bool changes() const noexcept { return stops_ || !intervals_.empty(); }
    const std::vector<TracedInterval>& intervals() const noexcept { return intervals_; }

private:
    void add(const Sample& sample) noexcept {
        const bool cuts = cutsIn(sample), begins = cuts && !cutBefore_;
        stops_ = stops_ || !cuts;
        while (next_ < intervals_.size() && index_ >= end(intervals_[next_])) ++next_;
        if (next_ < intervals_.size() && intervals_[next_].samples.contains(index_)) {
            TracedInterval& interval = intervals_[next_];
            if (index_ == interval.samples.first) interval.withinOne = cuts && cutBefore_;
            if (begins) ++interval.strokes;
        }
        cutBefore_ = cuts;
        ++index_;
    }
    static std::uint64_t end(const TracedInterval& interval) noexcept {
        return interval.samples.first + interval.samples.count;
    }

    std::vector<TracedInterval> intervals_; ///< rising
    std::size_t next_ = 0;
    std::uint64_t index_ = 0;
    bool cutBefore_ = false, stops_ = false;
};

/// Writes a take as a trace of ticks, with changes between them.
class TickTraceText {
public:
    TickTraceText(const TakeOutline& take, const std::vector<TracedInterval>& intervals)
        : period_(take.info.tickPeriod), rest_(intervals) {}

    void append(std::string& text, const Sample& sample) {
        endInterval(text);
        const bool passes = !rest_.empty() && rest_.front().withinOne && rest_.front().samples.contains(index_);
        const bool turns = cutsIn(sample) && !passes;
        if (turns != turns_) change(text, SpindleRelease{turns});
        turns_ = turns;
        StylusState reading = readingOf(sample);
        reading.period = index_ == 0 ? period_ : periodUntil(sample.time);
        appendTick(text, reading);
        time_ = sample.time;
        ++index_;
    }
    /// Call after the last sample.
    void finish(std::string& text) { endInterval(text); }

private:
    void endInterval(std::string& text) {
        if (rest_.empty() || index_ < rest_.front().samples.first + rest_.front().samples.count) return;
        if (!rest_.front().withinOne)
            for (std::size_t i = 0; i < rest_.front().strokes; ++i) change(text, WorkpieceChange{.undone = true});
        rest_ = rest_.subspan(1);
    }
    void change(std::string& text, const StepChange& told) { words_.append(text, {&changeMark, 1}, told); }
    /// The difference of two times, without their rounding errors: a whole number of ticks unless the device paced
    /// them.
    double periodUntil(double time) const noexcept {
        constexpr double roundingError = 1e-9; // s
        const double passed = time - time_, ticks = std::round(passed / period_);
        return std::abs(passed - ticks * period_) < roundingError ? ticks * period_ : passed;
    }

    const double period_;                  ///< s
    std::span<const TracedInterval> rest_; ///< intervals that are not over
    StepChangeWriter words_;
    std::uint64_t index_ = 0;
    double time_ = 0.0; ///< s
    bool turns_ = true; ///< a take begins with the spindle on
};

} // namespace

Result<void> writeTakeTrace(const std::filesystem::path& file, const TakeOutline& take, const SampleSource& samples) {
    TakeOutlook outlook(take);
    Result<void> done = samples([&outlook](std::span<const Sample> part) -> Result<void> {
        outlook.add(part);
        return {};
    });
    if (!done) return done;
    if (!outlook.changes()) return writeTakeTrace(file, samples);
    Result<StagedFile> staged = StagedFile::begin(file);
    if (!staged) return std::move(staged).error();
    std::string text;
    text.append(tickTraceMark).append("\n").append(tickTraceHeader).append("\n");
    TickTraceText trace(take, outlook.intervals());
    done = samples([&](std::span<const Sample> part) {
        for (const Sample& sample : part) trace.append(text, sample);
        Result<void> written = staged->append(text);
        text.clear();
        return written;
    });
    if (!done) return done;
    trace.finish(text);
    done = staged->append(text);
    if (done) done = staged->flush();
    return done ? staged->putInPlace() : done;
}

} // namespace burin
