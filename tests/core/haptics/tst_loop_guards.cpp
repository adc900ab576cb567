// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/servo_loop.h"
#include "core/haptics/loop/servo_tick.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/core/haptics/own_stylus.h"
#include "tests/core/haptics/pressed_stylus.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <thread>

namespace burin::tst_loop_guards {

using namespace burin::test;

namespace {

/// A stylus with a clock of its own, whose hand presses.
std::unique_ptr<OwnStylus> ownStylus(Motors& motors, Trick trick = {}) {
    StylusDescription description = desktopStylus();
    description.rate = {1000.0, "made up"};
    return std::make_unique<OwnStylus>(
        description,
        [trick](double time, int reading) {
            trick.play(reading);
            return pressing(time);
        },
        [&motors](const Wrench& wrench) { motors.force = glm::length(wrench.force); }, [&motors] { motors.cut(); });
}

/// Keeps all notifications of a loop.
class Log final : public TickSink {
public:
    Log() {
        samples.reserve(4000);
        timings.reserve(4000);
    }
    AtEdge edge() noexcept override { return samples.size() < 4000 ? AtEdge::tick : AtEdge::full; }
    void tick(const Sample& sample, const TickTiming& timing) noexcept override {
        samples.push_back(sample);
        timings.push_back(timing);
    }
    std::vector<Sample> samples;
    std::vector<TickTiming> timings;
};

struct Alarm final : LoopAlarm {
    void loopDied() noexcept override { ++deaths; }
    std::atomic<int> deaths{0};
};

enum class Kind { called, own };

/// Runs a loop with a stylus of the given kind until its hand has pressed for a while.
struct LoopRun {
    LoopRun(Kind kind, Trick trick, double seconds, double rampSeconds = 0.0) {
        HapticSettings haptic = Rig::settings();
        haptic.rampSeconds = rampSeconds;
        Rig rig(haptic);
        CalledStylus called(motors, trick);
        const auto own = ownStylus(motors, trick);
        ServoSettings settings;
        settings.maximumSeconds = seconds;
        const StylusHandle stylus = kind == Kind::called ? StylusHandle(called) : StylusHandle(*own);
        const Result<LoopStatistics> result = runServoLoop(stylus, rig.step, log, settings, stop);
        if (result) statistics = *result;
    }
    /// The tick whose reading was delayed.
    std::size_t afterGap(double atLeast) const {
        for (std::size_t i = 1; i < log.timings.size(); ++i)
            if (log.timings[i].over - log.timings[i - 1].over >= nanoseconds(atLeast)) return i;
        return 0;
    }
    Motors motors;
    Log log;
    std::atomic<bool> stop{false};
    LoopStatistics statistics;
};

} // namespace

/// Reactions of a loop to timing, whoever controls the clock. Where a time limit is stated, it is one that a busy
/// machine can only exceed, or one that the reaction is compared with.
class TestLoopGuards : public QObject {
    Q_OBJECT
private slots:
    /// The force is the return value of the call that brought the pose.
    void aSelfPacedStylusIsAnsweredInItsOwnCall() {
        const LoopRun run(Kind::own, {}, 0.5);
        QCOMPARE(run.statistics.ticks, std::uint64_t{run.log.samples.size()});
        QVERIFY(run.log.samples.size() > 10);
        double pressed = 0.0;
        for (std::size_t i = 0; i < run.log.samples.size(); ++i) {
            const Sample& sample = run.log.samples[i];
            pressed = std::max(pressed, glm::length(sample.force));
            QCOMPARE(sample.tick, std::uint64_t{i});
            QCOMPARE(sample.device.position, run.log.timings[i].reading.pose.position);
        }
        QVERIFY(pressed > 0.2);                 // N: 1 mm into the floor
        QCOMPARE(run.motors.force.load(), 0.0); // and no force remains
        QVERIFY(run.statistics.simulatedSeconds >= 0.499);
    }

    void aFullSinkEndsASelfPacedLoopToo() {
        struct Full final : TickSink {
            AtEdge edge() noexcept override { return ticks < 20 ? AtEdge::tick : AtEdge::full; }
            void tick(const Sample&, const TickTiming&) noexcept override { ++ticks; }
            int ticks = 0;
        } sink;
        Rig rig;
        Motors motors;
        const auto stylus = ownStylus(motors);
        const std::atomic<bool> stop{false};
        const auto result = runServoLoop(*stylus, rig.step, sink, {}, stop);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::recordingOverflow);
        QCOMPARE(sink.ticks, 20);
        const auto fast = runServoLoop(*stylus, rig.step, sink, {.pace = Pace::fast}, stop);
        QCOMPARE(fast.error().code, ErrorCode::argumentInvalid);
    }

    void aForceThatComesTooLateIsWithheld_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("gap");
        QTest::addColumn<bool>("fadesIn");
        for (const auto& [name, kind] : {std::pair{"called", Kind::called}, {"self-paced", Kind::own}}) {
            QTest::addRow("%s, 5 ms", name) << int(kind) << 0.005 << false;
            QTest::addRow("%s, 20 ms", name) << int(kind) << 0.020 << true;
        }
    }
    /// After three milliseconds there is no force in that tick, and it is counted. After ten, forces fade in again.
    void aForceThatComesTooLateIsWithheld() {
        QFETCH(int, kind);
        QFETCH(double, gap);
        QFETCH(bool, fadesIn);
        constexpr double ramp = 0.05;
        const LoopRun run(static_cast<Kind>(kind), {150, gap}, 0.5, ramp);
        const std::size_t late = run.afterGap(gap);
        QVERIFY(late > 0 && late + 1 < run.log.samples.size());
        QCOMPARE(run.log.samples[late].force, glm::dvec3(0.0));
        QVERIFY((run.log.samples[late].flags & sampleForcesOff) != 0);
        QVERIFY(run.statistics.late >= 1);
        QVERIFY(run.log.timings.back().late >= 1);
        if (!fadesIn) return;
        // The step is informed of a gap with the reading after it.
        bool told = false;
        for (std::size_t i = late; i < std::min(late + 3, run.log.samples.size()); ++i)
            told = told || run.log.timings[i].fault == TickFault::stalled;
        QVERIFY(told);
        const std::size_t faded = std::min(late + 5, run.log.samples.size() - 1);
        QVERIFY((run.log.samples[faded].flags & sampleForcesOff) != 0);
    }

    void aStepThatHangsCostsTheMotors_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("called") << int(Kind::called);
        QTest::newRow("self-paced") << int(Kind::own);
    }
    /// The figure `stop.ms` allows 60 ms on a quiet machine; on a busy one the watchdog may run later. This test shows
    /// that the motors are off long before the step is finished.
    void aStepThatHangsCostsTheMotors() {
        QFETCH(int, kind);
        BlockingField field;
        field.seconds = 1.5;
        RunVolume volume = stockOnPart();
        HapticStep step(volume, field, ballTool(), Rig::settings());
        Motors motors;
        CalledStylus called(motors);
        const auto own = ownStylus(motors);
        Log log;
        Alarm alarm;
        std::atomic<bool> stop{false};
        ServoSettings settings;
        settings.alarm = &alarm;
        Result<LoopStatistics> result = LoopStatistics{};
        std::thread loop([&] {
            const StylusHandle stylus = kind == int(Kind::called) ? StylusHandle(called) : StylusHandle(*own);
            result = runServoLoop(stylus, step, log, settings, stop);
        });
        const auto until = now() + nanoseconds(20.0);
        while (motors.force < 0.2 && now() < until) waitFor(0.001);
        QVERIFY(motors.force >= 0.2);
        const int before = motors.cuts;
        field.blocks = true;
        while (motors.cuts == before && now() < until) waitFor(0.0005);
        const std::int64_t cutAt = motors.cutAt, blockedAt = field.blockedAt;
        QCOMPARE(motors.force.load(), 0.0);
        QVERIFY2(seconds(cutAt - blockedAt) < 1.0, qPrintable(QString::number(seconds(cutAt - blockedAt))));
        QVERIFY(seconds(cutAt - blockedAt) > 0.040); // not at the first short delay
        waitFor(0.2);
        QCOMPARE(motors.force.load(), 0.0);       // and they stay off
        QCOMPARE(motors.cuts.load(), before + 1); // reported once
        // Then the step continues: its computed force is not sent, and forces return.
        while (motors.force < 0.2 && now() < until) waitFor(0.001);
        stop = true;
        loop.join();
        QVERIFY(result.hasValue());
        QVERIFY(result->cuts >= 1 && alarm.deaths == int(result->cuts));
        QVERIFY(result->cutSeconds >= 0.050 && result->cutSeconds < 1.0);
        std::size_t after = 0;
        for (std::size_t i = 1; i < log.timings.size(); ++i)
            if (log.timings[i].over >= blockedAt + nanoseconds(1.4) && after == 0) after = i;
        QVERIFY(after > 0);
        QCOMPARE(log.samples[after].force, glm::dvec3(0.0));
        QVERIFY((log.samples[after].flags & sampleForceLate) != 0);
    }

    /// A device that got no force because it was too late holds none: its next force rises from zero, however punctual
    /// the next tick is.
    void afterAForceThatWasWithheldTheNextOneRises() {
        Rig rig;
        rig.begin({0.0, 0.0, 5.0});
        rig.moveTo({0.0, 0.0, floorHeight - 15.0}, 100.0);
        rig.rest(200);
        const double pressed = glm::length(rig.step.deviceWrench().force), rise = rig.step.limiter().riseStep();
        QVERIFY(pressed > 5.0 * rise);
        StylusState reading;
        reading.pose.position = rig.hand;
        reading.valid = true;
        Log log;
        ServoTick tick(rig.step, log, period, true);
        const auto force = [&](double seconds) {
            tick.begin();
            waitFor(seconds);
            const Wrench wrench = tick.serve(reading, period);
            tick.sent();
            return glm::length(wrench.force);
        };
        QCOMPARE(force(0.004), 0.0); // ready after 4 ms
        double before = 0.0;
        for (int i = 0; i < 50; ++i) {
            const double now = force(0.0);
            QVERIFY(now - before <= rise + 1e-12);
            before = now;
        }
        QVERIFY(before > 0.0);
        QCOMPARE(log.samples.front().force, glm::dvec3(0.0));
    }

    /// A loop that was asked to stop, or whose device is away, must not raise an alarm.
    void aLoopThatStandsIsNotDead() {
        struct Standing final : TickSink {
            AtEdge edge() noexcept override { return ticks == 20 && edges++ < 150 ? AtEdge::stand : AtEdge::tick; }
            void tick(const Sample&, const TickTiming& timing) noexcept override {
                if (++ticks == 21) firstInterval = timing.interval;
            }
            int ticks = 0, edges = 0;
            std::int64_t firstInterval = -1;
        } sink;
        Rig rig;
        Motors motors;
        CalledStylus stylus(motors);
        const std::atomic<bool> stop{false};
        ServoSettings settings;
        settings.maximumSeconds = 0.4;
        const auto result = runServoLoop(stylus, rig.step, sink, settings, stop);
        QVERIFY(result.hasValue());
        QCOMPARE(sink.firstInterval, std::int64_t{0}); // standing still is no gap
    }

    void theStatisticsTellTheIntervals() {
        const LoopRun run(Kind::called, {}, 0.3);
        const LoopStatistics& s = run.statistics;
        QVERIFY(s.intervalP50 > 0.0 && s.intervalP50 <= s.intervalP99 && s.intervalP99 <= s.intervalP999);
        QVERIFY(s.intervalP999 <= s.intervalMaximum);
        // The mean of all intervals is the time between the first and the last force.
        std::int64_t sum = 0;
        for (const TickTiming& timing : run.log.timings) sum += timing.interval;
        QCOMPARE(sum, run.log.timings.back().over - run.log.timings.front().over);
    }

    /// Dead man's button: no force without it, none from the very tick in which it is released, and returning force
    /// fades in.
    void forcesNeedTheirButtonHeld() {
        HapticSettings settings = Rig::settings();
        settings.forceButtons = 0b110; // the second or the third
        settings.rampSeconds = 0.05;
        Rig rig(settings);
        rig.begin({0, 0, 2});
        rig.moveTo({0, 0, floorHeight - 1.0}, 40.0);
        const auto pressWith = [&rig](std::uint32_t buttons, int ticks) {
            rig.buttons = buttons;
            return glm::length(rig.rest(ticks).force);
        };
        QCOMPARE(pressWith(0b000, 200), 0.0);
        QCOMPARE(pressWith(0b001, 200), 0.0);
        const double first = pressWith(0b100, 1), whole = pressWith(0b100, 200);
        QVERIFY(whole > 0.2);
        QVERIFY(first < 0.05 * whole);
        QVERIFY(std::abs(pressWith(0b010, 50) - whole) < 0.05 * whole);
        QCOMPARE(pressWith(0b001, 1), 0.0);
        QCOMPARE(rig.step.deviceWrench().force, glm::dvec3(0.0));
        QVERIFY(pressWith(0b010, 1) < 0.05 * whole);
    }

    /// Slower devices are not late with each of their ticks.
    void limitsOfGapsGoWithThePeriod() {
        QCOMPARE(gapLimits(0.001).late, 0.003);
        QCOMPARE(gapLimits(0.001).stalled, 0.010);
        QCOMPARE(gapLimits(0.00025).late, 0.003);
        QCOMPARE(gapLimits(0.00025).dead, 0.050);
        QCOMPARE(gapLimits(0.01).late, 0.03);
        QVERIFY(gapLimits(0.01).dead >= gapLimits(0.01).stalled);
    }
};

BURIN_TEST(TestLoopGuards, NoApplication)

} // namespace burin::tst_loop_guards

#include "tst_loop_guards.moc"
