// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/pacing.h"
#include "core/haptics/loop/tick_thread.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace burin {
namespace {

class ClockPacing {
public:
    ClockPacing(Stylus& stylus, ServoTick& tick, const ServoSettings& settings, const std::atomic<bool>& stop,
                PacingOutcome& outcome) noexcept
        : stylus_(stylus)
        , tick_(tick)
        , settings_(settings)
        , stop_(stop)
        , outcome_(outcome)
        , period_(nanoseconds(settings.period)) {}
    /// Sets the device's force to zero, whatever ends the loop.
    ~ClockPacing() { stylus_.write({}); }
    ClockPacing(const ClockPacing&) = delete;
    ClockPacing& operator=(const ClockPacing&) = delete;

    void runFast() noexcept;
    void runRealtime() noexcept;

private:
    bool finished() const noexcept;
    AtEdge edge() noexcept;
    AtEdge lapse() noexcept;
    void tick(double period) noexcept;
    std::int64_t edgeAfter(std::int64_t edge) noexcept;

    Stylus& stylus_;
    ServoTick& tick_;
    const ServoSettings& settings_;
    const std::atomic<bool>& stop_;
    PacingOutcome& outcome_;
    const std::int64_t period_; ///< ns
    std::int64_t start_ = 0;    ///< ns
    double simulated_ = 0.0;    ///< s, sum of the differences of the ticks' periods from the nominal one
};

bool ClockPacing::finished() const noexcept {
    // Half a period: rounding errors in the sum of periods must not turn 1000 ticks into 1001.
    return stop_.load(std::memory_order_relaxed) || stylus_.finished() ||
           outcome_.time >= settings_.maximumSeconds - 0.5 * settings_.period;
}

AtEdge ClockPacing::edge() noexcept {
    const AtEdge answer = tick_.edge();
    if (answer == AtEdge::stand) stylus_.write({});
    return answer;
}

void ClockPacing::tick(double period) noexcept {
    const std::int64_t before = now(CLOCK_THREAD_CPUTIME_ID);
    tick_.begin();
    const StylusState reading = stylus_.read(outcome_.time);
    stylus_.write(tick_.serve(reading, reading.period != 0.0 ? reading.period : period));
    tick_.sent();
    tick_.spent(now(CLOCK_THREAD_CPUTIME_ID) - before);
}

/// Simulated time: as many periods as ticks, unless the stylus specifies its own periods.
void ClockPacing::runFast() noexcept {
    while (!finished()) {
        if (edge() != AtEdge::tick) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            continue;
        }
        tick(settings_.period);
        simulated_ += std::max(tick_.timing().period, 0.0) - settings_.period;
        outcome_.time = static_cast<double>(tick_.ticks()) * settings_.period + simulated_;
    }
}

/// Runs the ticks of one edge in a time lapse. Returns the reason why the last of them was not made, if any.
AtEdge ClockPacing::lapse() noexcept {
    for (int i = 0; i < settings_.ticksPerEdge && !finished(); ++i) {
        if (const AtEdge answer = edge(); answer != AtEdge::tick) return answer;
        tick(settings_.period);
        outcome_.time = static_cast<double>(tick_.ticks()) * settings_.period;
    }
    return AtEdge::tick;
}

/// Sleeps until the next edge that is still ahead: never catches up in a burst.
/// @return the edge at which this thread runs again: a later one if it was woken late
std::int64_t ClockPacing::edgeAfter(std::int64_t edge) noexcept {
    const std::int64_t passed = (now() - start_) / period_;
    const std::int64_t next = passed > edge ? passed + 1 : edge + 1;
    const std::int64_t due = start_ + next * period_;
    sleepUntil(due);
    const std::int64_t woken = now();
    outcome_.lateness.add(woken - due);
    return std::max(next, (woken - start_) / period_);
}

void ClockPacing::runRealtime() noexcept {
    const TickThread thread;
    outcome_.memoryLocked = outcome_.memoryLocked && thread.stackLocked();
    const bool lapsing = settings_.ticksPerEdge > 1;
    start_ = now();
    std::int64_t edge = 0, lastTick = -1; // counted from the start
    while (!finished()) {
        tick_.scheduled(thread.scheduling());
        const AtEdge answer = lapsing ? lapse() : this->edge();
        if (answer == AtEdge::full && !lapsing) {
            outcome_.overflow = true;
            return;
        }
        if (answer == AtEdge::tick && !lapsing) {
            tick(static_cast<double>(edge - lastTick) * settings_.period);
            lastTick = edge;
        }
        const std::int64_t next = edgeAfter(edge);
        if (answer == AtEdge::tick) tick_.missed(static_cast<std::uint64_t>(next - edge - 1));
        edge = next;
        if (!lapsing) outcome_.time = static_cast<double>(edge) * settings_.period;
    }
}

} // namespace

void paceByClock(Stylus& stylus, ServoTick& tick, const ServoSettings& settings, const std::atomic<bool>& stop,
                 PacingOutcome& outcome) noexcept {
    const DenormalsAreZero denormals;
    ClockPacing pacing(stylus, tick, settings, stop, outcome);
    if (settings.pace == Pace::fast)
        pacing.runFast();
    else
        pacing.runRealtime();
}

} // namespace burin
