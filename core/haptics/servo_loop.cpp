// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/servo_loop.h"

#include "core/base/numbers.h"
#include "core/haptics/duration_histogram.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/realtime_scheduling.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <time.h>

namespace burin {
namespace {

constexpr std::int64_t nanosecondsPerSecond = 1'000'000'000;

std::int64_t now(clockid_t clock) noexcept {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<std::int64_t>(time.tv_sec) * nanosecondsPerSecond + time.tv_nsec;
}

void sleepUntil(std::int64_t nanoseconds) noexcept {
    timespec edge{};
    edge.tv_sec = static_cast<time_t>(nanoseconds / nanosecondsPerSecond);
    edge.tv_nsec = static_cast<long>(nanoseconds % nanosecondsPerSecond);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &edge, nullptr) == EINTR) {
    }
}

/// No force stays on a device, whatever ends the loop.
class ZeroForceAtExit {
public:
    explicit ZeroForceAtExit(Stylus& stylus) noexcept : stylus_(stylus) {}
    ~ZeroForceAtExit() { stylus_.write({}); }
    ZeroForceAtExit(const ZeroForceAtExit&) = delete;
    ZeroForceAtExit& operator=(const ZeroForceAtExit&) = delete;

private:
    Stylus& stylus_;
};

struct Histograms {
    DurationHistogram work, cpu, lateness;
};

class ServoLoop {
public:
    ServoLoop(Stylus& stylus, HapticStep& step, TickSink& sink, const ServoSettings& settings,
              const std::atomic<bool>& stop)
        : stylus_(stylus)
        , step_(step)
        , sink_(sink)
        , settings_(settings)
        , stop_(stop)
        , periodNanoseconds_(std::llround(settings.period * static_cast<double>(nanosecondsPerSecond)))
        , histograms_(std::make_unique<Histograms>()) {}

    Result<LoopStatistics> run();

private:
    enum class End : std::uint8_t { done, overflow };
    bool finished() const noexcept;
    AtEdge edge() noexcept;
    End runFast() noexcept;
    End runRealtime() noexcept;
    AtEdge lapse() noexcept;
    void tick(double period) noexcept;
    LoopStatistics statistics(double wallSeconds) const noexcept;

    Stylus& stylus_;
    HapticStep& step_;
    TickSink& sink_;
    const ServoSettings& settings_;
    const std::atomic<bool>& stop_;
    std::int64_t periodNanoseconds_;
    std::unique_ptr<Histograms> histograms_;
    std::uint64_t ticks_ = 0;
    double time_ = 0.0; ///< s of the session
    TickTiming timing_;
};

bool ServoLoop::finished() const noexcept {
    // Half a period: the sum of periods must not turn 1000 ticks into 1001.
    return stop_.load(std::memory_order_relaxed) || stylus_.finished() ||
           time_ >= settings_.maximumSeconds - 0.5 * settings_.period;
}

AtEdge ServoLoop::edge() noexcept {
    const AtEdge answer = sink_.edge();
    if (answer == AtEdge::stand) stylus_.write({});
    return answer;
}

void ServoLoop::tick(double period) noexcept {
    const std::int64_t wall = now(CLOCK_MONOTONIC), cpu = now(CLOCK_THREAD_CPUTIME_ID);
    const StylusState state = stylus_.read(time_);
    const Sample sample = step_(state, period);
    stylus_.write(step_.deviceWrench());
    timing_.period = period;
    timing_.over = now(CLOCK_MONOTONIC);
    sink_.tick(sample, timing_);
    timing_.cpu = now(CLOCK_THREAD_CPUTIME_ID) - cpu;
    timing_.work = now(CLOCK_MONOTONIC) - wall;
    histograms_->cpu.add(timing_.cpu);
    histograms_->work.add(timing_.work);
    ++ticks_;
}

ServoLoop::End ServoLoop::runFast() noexcept {
    while (!finished()) {
        if (edge() != AtEdge::tick) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            continue;
        }
        tick(settings_.period);
        time_ = static_cast<double>(ticks_) * settings_.period;
    }
    return End::done;
}

ServoLoop::End ServoLoop::runRealtime() noexcept {
    const RealtimeScheduling scheduling;
    timing_.scheduling = scheduling.obtained();
    const bool lapsing = settings_.ticksPerEdge > 1;
    const std::int64_t start = now(CLOCK_MONOTONIC);
    std::int64_t edge = 0, edgeBefore = -1, lastTick = -1; // counted from the start
    while (!finished()) {
        const AtEdge answer = lapsing ? lapse() : this->edge();
        if (answer == AtEdge::full && !lapsing) return End::overflow;
        if (answer == AtEdge::tick && !lapsing) {
            tick(static_cast<double>(edge - lastTick) * settings_.period);
            lastTick = edge;
        }
        edgeBefore = edge;
        // Never catch up in a burst: after an overrun the next edge that is still ahead.
        const std::int64_t passed = (now(CLOCK_MONOTONIC) - start) / periodNanoseconds_;
        edge = passed > edge ? passed + 1 : edge + 1;
        if (answer == AtEdge::tick) timing_.missed += static_cast<std::uint64_t>(edge - edgeBefore - 1);
        const std::int64_t due = start + edge * periodNanoseconds_;
        sleepUntil(due);
        histograms_->lateness.add(now(CLOCK_MONOTONIC) - due);
        if (!lapsing) time_ = static_cast<double>(edge) * settings_.period;
    }
    return End::done;
}

/// The ticks of one edge. What kept the last of them from being made, if anything did.
AtEdge ServoLoop::lapse() noexcept {
    for (int i = 0; i < settings_.ticksPerEdge && !finished(); ++i) {
        if (const AtEdge answer = edge(); answer != AtEdge::tick) return answer;
        tick(settings_.period);
        time_ = static_cast<double>(ticks_) * settings_.period;
    }
    return AtEdge::tick;
}

Result<LoopStatistics> ServoLoop::run() {
    const ZeroForceAtExit zeroForce(stylus_);
    const std::int64_t start = now(CLOCK_MONOTONIC);
    const End end = settings_.pace == Pace::fast ? runFast() : runRealtime();
    step_.settle();
    const double wallSeconds =
        static_cast<double>(now(CLOCK_MONOTONIC) - start) / static_cast<double>(nanosecondsPerSecond);
    if (end == End::overflow)
        return Error{ErrorCode::recordingOverflow, std::to_string(ticks_), "", "the ring of samples is full"};
    return statistics(wallSeconds);
}

LoopStatistics ServoLoop::statistics(double wallSeconds) const noexcept {
    LoopStatistics result;
    result.ticks = ticks_;
    result.simulatedSeconds = time_;
    result.wallSeconds = wallSeconds;
    result.rateHz = wallSeconds > 0.0 ? static_cast<double>(ticks_) / wallSeconds : 0.0;
    result.workP50 = histograms_->work.quantileMicroseconds(0.5);
    result.workP99 = histograms_->work.quantileMicroseconds(0.99);
    result.workP999 = histograms_->work.quantileMicroseconds(0.999);
    result.workMaximum = histograms_->work.largestMicroseconds();
    result.cpuP50 = histograms_->cpu.quantileMicroseconds(0.5);
    result.cpuP999 = histograms_->cpu.quantileMicroseconds(0.999);
    result.latenessP50 = histograms_->lateness.quantileMicroseconds(0.5);
    result.latenessP999 = histograms_->lateness.quantileMicroseconds(0.999);
    result.missed = timing_.missed;
    result.scheduling = timing_.scheduling;
    return result;
}

} // namespace

Result<LoopStatistics> runServoLoop(Stylus& stylus, HapticStep& step, TickSink& sink, const ServoSettings& settings,
                                    const std::atomic<bool>& stop) {
    if (!std::isfinite(settings.period) || settings.period < 1e-6)
        return Error{ErrorCode::argumentInvalid, "period", formatShortest(settings.period), "1e-6 s or more"};
    if (settings.ticksPerEdge < 1)
        return Error{ErrorCode::argumentInvalid, "ticks per edge", std::to_string(settings.ticksPerEdge), "1 or more"};
    return ServoLoop(stylus, step, sink, settings, stop).run();
}

Result<LoopStatistics> runServoLoop(Stylus& stylus, HapticStep& step, Ring<Sample>& samples,
                                    const ServoSettings& settings, const std::atomic<bool>& stop) {
    RingSink sink(samples);
    return runServoLoop(stylus, step, sink, settings, stop);
}

} // namespace burin
