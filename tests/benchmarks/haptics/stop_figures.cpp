// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop_clock.h"
#include "core/haptics/servo_loop.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/core/haptics/haptic_bench.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace burin::benchmarks {

namespace {

constexpr double limit = 60.0;   // ms
constexpr double hangs = 0.2;    // s, that the loop is kept from going on
constexpr std::size_t runs = 20; // the worst counts

/// A hand that presses on the floor; once its motors push it hangs in a reading, until somebody has cut them.
class HangingStylus final : public Stylus {
public:
    StylusDescription description() const override { return test::desktopStylus(); }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    void cutMotors() noexcept override {
        if (hungAt_ > 0 && cutAt_ == 0) cutAt_ = now();
    }
    StylusState read(double time) noexcept override {
        if (pushes_ && hungAt_ == 0) {
            hungAt_ = sentAt_;
            std::this_thread::sleep_for(std::chrono::duration<double>(hangs));
        }
        StylusState state;
        state.time = time;
        state.pose.position = {0.0, 0.0, std::max(test::floorHeight - 1.0, 2.0 - 200.0 * time)};
        state.valid = true;
        return state;
    }
    void write(const Wrench& wrench) noexcept override {
        sentAt_ = now();
        pushes_ = glm::length(wrench.force) > 0.2;
    }
    bool finished() const noexcept override { return hungAt_ > 0; }
    /// ms from the last force that was sent until the motors were off; how long it hung if nobody cut them.
    double stopped() const noexcept { return 1e3 * (cutAt_ > 0 ? seconds(cutAt_ - hungAt_) : hangs); }

private:
    std::atomic<std::int64_t> hungAt_{0}, cutAt_{0};
    std::int64_t sentAt_ = 0;
    bool pushes_ = false;
};

struct Nowhere final : TickSink {
    AtEdge edge() noexcept override { return AtEdge::tick; }
    void tick(const Sample&, const TickTiming&) noexcept override {}
};

} // namespace

void stopFigures(Session& session) {
    if (!session.wants("stop.")) return;
    std::vector<double> milliseconds;
    for (std::size_t run = 0; run < runs; ++run) {
        session.stage("stop.ms");
        test::Bench bench;
        HangingStylus stylus;
        Nowhere sink;
        const std::atomic<bool> stop{false};
        ServoSettings settings;
        settings.maximumSeconds = 5.0;
        require(runServoLoop(stylus, bench.step, sink, settings, stop), "a servo loop");
        milliseconds.push_back(stylus.stopped());
    }
    session.add(figure("stop.ms", std::ranges::max(milliseconds), "ms", limit));
}

} // namespace burin::benchmarks
