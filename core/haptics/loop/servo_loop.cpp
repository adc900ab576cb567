// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/servo_loop.h"

#include "core/base/numbers.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/tick_thread.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace burin {
namespace {

Result<void> checkSettings(const StylusHandle& stylus, const ServoSettings& settings) {
    if (!std::isfinite(settings.period) || settings.period < 1e-6)
        return Error{ErrorCode::argumentInvalid, "period", formatShortest(settings.period), "1e-6 s or more"};
    if (settings.ticksPerEdge < 1)
        return Error{ErrorCode::argumentInvalid, "ticks per edge", std::to_string(settings.ticksPerEdge), "1 or more"};
    if (stylus.selfPaced() != nullptr && (settings.pace != Pace::realtime || settings.ticksPerEdge > 1))
        return Error{ErrorCode::argumentInvalid, "pace", "fast", "realtime with a device that keeps its own time"};
    return {};
}

bool byTheClock(const ServoSettings& settings) noexcept {
    return settings.pace == Pace::realtime && settings.ticksPerEdge == 1;
}

LoopStatistics statistics(const ServoTick& tick, const PacingOutcome& outcome, double wallSeconds) noexcept {
    const ServoTick::Histograms& durations = tick.histograms();
    LoopStatistics result;
    result.ticks = tick.ticks();
    result.simulatedSeconds = outcome.time;
    result.wallSeconds = wallSeconds;
    result.rateHz = wallSeconds > 0.0 ? static_cast<double>(result.ticks) / wallSeconds : 0.0;
    result.workP50 = durations.work.quantileMicroseconds(0.5);
    result.workP99 = durations.work.quantileMicroseconds(0.99);
    result.workP999 = durations.work.quantileMicroseconds(0.999);
    result.workMaximum = durations.work.largestMicroseconds();
    result.cpuP50 = durations.cpu.quantileMicroseconds(0.5);
    result.cpuP999 = durations.cpu.quantileMicroseconds(0.999);
    result.cpuMaximum = durations.cpu.largestMicroseconds();
    result.intervalP50 = durations.interval.quantileMicroseconds(0.5);
    result.intervalP99 = durations.interval.quantileMicroseconds(0.99);
    result.intervalP999 = durations.interval.quantileMicroseconds(0.999);
    result.intervalMaximum = durations.interval.largestMicroseconds();
    result.latenessP50 = outcome.lateness.quantileMicroseconds(0.5);
    result.latenessP999 = outcome.lateness.quantileMicroseconds(0.999);
    result.missed = tick.timing().missed;
    result.late = tick.timing().late;
    result.scheduling = tick.timing().scheduling;
    result.memoryLocked = outcome.memoryLocked;
    return result;
}

} // namespace

Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, TickSink& sink,
                                    const ServoSettings& settings, const std::atomic<bool>& stop) {
    if (const Result<void> checked = checkSettings(stylus, settings); !checked) return checked.error();
    if (byTheClock(settings)) makeCodeResident();
    const auto tick = std::make_unique<ServoTick>(step, sink, settings.period, byTheClock(settings));
    const auto outcome = std::make_unique<PacingOutcome>();
    const LockedMemory tickMemory(tick.get(), sizeof *tick), stepMemory(&step, sizeof step);
    outcome->memoryLocked = byTheClock(settings) && tickMemory.locked() && stepMemory.locked();
    std::optional<LoopWatchdog> watchdog;
    if (byTheClock(settings))
        watchdog.emplace(stylus.device(), tick->heart(), gapLimits(settings.period).dead, settings.alarm);
    const std::int64_t start = now();
    if (Stylus* called = stylus.called())
        paceByClock(*called, *tick, settings, stop, *outcome);
    else if (Result<void> ran = paceByDevice(*stylus.selfPaced(), *tick, settings, stop, *outcome); !ran)
        return std::move(ran).error();
    tick->heart().rest();
    step.settle();
    LoopStatistics result = statistics(*tick, *outcome, seconds(now() - start));
    if (watchdog) {
        result.cuts = watchdog->cuts().count;
        result.cutSeconds = watchdog->cuts().longest;
    }
    if (outcome->overflow)
        return Error{ErrorCode::recordingOverflow, std::to_string(result.ticks), "", "the ring of samples is full"};
    return result;
}

Result<LoopStatistics> runServoLoop(const StylusHandle& stylus, HapticStep& step, Ring<Sample>& samples,
                                    const ServoSettings& settings, const std::atomic<bool>& stop) {
    RingSink sink(samples);
    return runServoLoop(stylus, step, sink, settings, stop);
}

} // namespace burin
