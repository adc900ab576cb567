// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/pacing.h"
#include "core/haptics/loop/tick_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

namespace burin {
namespace {

/// Interval at which the owner's thread checks whether the loop is over.
constexpr std::chrono::milliseconds glance{2};

/// The loop's side of a self-paced stylus. The ticks run in the stylus' thread.
class DevicePacing final : public StylusClient {
public:
    DevicePacing(ServoTick& tick, const ServoSettings& settings, PacingOutcome& outcome) noexcept
        : tick_(tick), settings_(settings), outcome_(outcome) {}

    bool over() const noexcept { return over_.load(std::memory_order_acquire); }

    void begins() noexcept override;
    Wrench tick(const StylusState& reading) noexcept override;
    void answered() noexcept override;
    void ends() noexcept override;

private:
    double periodOf(const StylusState& reading, std::int64_t time) noexcept;

    ServoTick& tick_;
    const ServoSettings& settings_;
    PacingOutcome& outcome_;
    std::atomic<bool> over_{false};
    std::optional<TickThread> thread_; ///< settings of the stylus' thread; this member and the following are used by it
    std::optional<DenormalsAreZero> denormals_;
    std::optional<double> readBefore_; ///< s, the device's clock
    std::int64_t calledBefore_ = 0, cpuBefore_ = 0;
    bool ticked_ = false;
};

void DevicePacing::begins() noexcept {
    thread_.emplace();
    denormals_.emplace();
    outcome_.memoryLocked = outcome_.memoryLocked && thread_->stackLocked();
    cpuBefore_ = now(CLOCK_THREAD_CPUTIME_ID);
}

void DevicePacing::ends() noexcept {
    tick_.heart().rest();
    denormals_.reset();
    thread_.reset();
}

/// By the device's clock, which is not disturbed by the bus. But for gaps the longer of both durations counts: a device
/// whose clock stands still must not hide that the hand has waited.
double DevicePacing::periodOf(const StylusState& reading, std::int64_t time) noexcept {
    const double told = readBefore_ ? reading.time - *readBefore_ : settings_.period;
    const double waited = calledBefore_ > 0 ? seconds(time - calledBefore_) : settings_.period;
    readBefore_ = reading.time;
    calledBefore_ = time;
    return waited > gapLimits(settings_.period).late ? std::max(told, waited) : told;
}

Wrench DevicePacing::tick(const StylusState& reading) noexcept {
    ticked_ = false;
    if (over()) return {};
    tick_.begin();
    const double period = periodOf(reading, now());
    const AtEdge answer = tick_.edge();
    if (answer != AtEdge::tick) {
        outcome_.overflow = answer == AtEdge::full;
        if (outcome_.overflow) over_.store(true, std::memory_order_release);
        return {};
    }
    ticked_ = true;
    tick_.scheduled(thread_->scheduling());
    if (tick_.ticks() > 0 && std::isfinite(period)) outcome_.time += std::max(period, 0.0);
    if (const double skipped = std::round(period / settings_.period) - 1.0; skipped > 0.0)
        tick_.missed(static_cast<std::uint64_t>(std::min(skipped, 1e9)));
    return tick_.serve(reading, period);
}

void DevicePacing::answered() noexcept {
    if (ticked_) {
        tick_.sent();
        if (outcome_.time + 0.5 * settings_.period >= settings_.maximumSeconds)
            over_.store(true, std::memory_order_release);
    }
    const std::int64_t cpu = now(CLOCK_THREAD_CPUTIME_ID);
    if (ticked_) tick_.spent(cpu - cpuBefore_);
    cpuBefore_ = cpu;
}

} // namespace

Result<void> paceByDevice(SelfPacedStylus& stylus, ServoTick& tick, const ServoSettings& settings,
                          const std::atomic<bool>& stop, PacingOutcome& outcome) {
    DevicePacing pacing(tick, settings, outcome);
    if (Result<void> started = stylus.start(pacing); !started) return started;
    while (!stop.load(std::memory_order_relaxed) && !pacing.over()) std::this_thread::sleep_for(glance);
    stylus.stop();
    return {};
}

} // namespace burin
