// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/servo_loop.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/core/haptics/pressed_stylus.h"

namespace burin::benchmarks {

namespace {

/// Discards samples.
class NoSink final : public TickSink {
public:
    AtEdge edge() noexcept override { return AtEdge::tick; }
    void tick(const Sample&, const TickTiming&) noexcept override {}
};

/// The time from stopping a loop at 1 kHz in the middle of a tick, while its hand presses, until the motors are off,
/// ms.
double stopTime() {
    constexpr double longEnough = 0.3; // s that the tick hangs
    constexpr double patience = 20.0;  // s until the measurement is abandoned
    test::BlockingField field;
    field.seconds = longEnough;
    RunVolume volume = test::stockOnPart();
    HapticStep step(volume, field, test::ballTool(), test::Rig::settings());
    test::Motors motors;
    test::CalledStylus stylus(motors);
    NoSink sink;
    std::atomic<bool> stop{false};
    std::thread loop([&] { static_cast<void>(runServoLoop(stylus, step, sink, {}, stop)); });
    const std::int64_t until = now() + nanoseconds(patience);
    while (motors.force < 0.2 && now() < until) test::waitFor(0.001);
    const int before = motors.cuts;
    field.blocks = true;
    while (motors.cuts == before && now() < until) test::waitFor(0.001);
    const double spent = motors.cuts == before ? 1e3 * patience : 1e3 * burin::seconds(motors.cutAt - field.blockedAt);
    stop = true;
    loop.join();
    return spent;
}

} // namespace

void stopFigures(Session& session) {
    if (!session.wants("stop.")) return;
    session.stage("stop.ms");
    std::vector<double> times;
    for (int run = 0; run < 9; ++run) {
        Session::throwIfCancelled();
        times.push_back(stopTime());
    }
    session.add(figure("stop.ms", percentile(times, 0.5), "ms", 60.0));
    session.add(figure("stop.worst_ms", percentile(times, 1.0), "ms"));
}

} // namespace burin::benchmarks
