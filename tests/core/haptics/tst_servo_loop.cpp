// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/duration_histogram.h"
#include "core/haptics/loop/loop_figures.h"
#include "core/haptics/loop/servo_loop.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <thread>

namespace burin::tst_servo_loop {

using namespace burin::test;

namespace {

/// A hand that circles and presses as a function of the given time; keeps the forces that it was sent.
class CirclingStylus final : public Stylus {
public:
    explicit CirclingStylus(double endTime = 1e9) : endTime_(endTime) {}
    StylusDescription description() const override { return desktopStylus(); }
    Result<void> open() override { return {}; }
    StylusState read(double time) noexcept override {
        lastTime = time;
        StylusState state;
        state.time = time;
        state.pose.position = {8.0 * std::cos(3.0 * time), 8.0 * std::sin(3.0 * time), 2.0 - 6.0 * std::min(time, 2.5)};
        state.valid = true;
        return state;
    }
    void write(const Wrench& wrench) noexcept override {
        lastForce = wrench.force;
        largestForce = std::max(largestForce, glm::length(wrench.force));
        ++writes;
    }
    bool finished() const noexcept override { return lastTime >= endTime_; }
    void close() noexcept override {}

    double lastTime = -1.0, largestForce = 0.0;
    glm::dvec3 lastForce{9.0};
    int writes = 0;

private:
    double endTime_;
};

/// Takes samples out of the ring until told to stop.
class Reader {
public:
    explicit Reader(Ring<Sample>& ring) : ring_(ring), thread_([this] { run(); }) {}
    std::vector<Sample> finish() {
        end_ = true;
        thread_.join();
        return std::move(samples_);
    }

private:
    void run() {
        std::array<Sample, 64> batch;
        for (;;) {
            const bool last = end_;
            const std::size_t count = ring_.pop(batch);
            samples_.insert(samples_.end(), batch.begin(), batch.begin() + static_cast<std::ptrdiff_t>(count));
            if (count > 0) continue;
            if (last) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    Ring<Sample>& ring_;
    std::vector<Sample> samples_;
    std::atomic<bool> end_{false};
    std::thread thread_;
};

struct LoopRun {
    LoopStatistics statistics;
    std::vector<Sample> samples;
};

LoopRun runFast(CirclingStylus& stylus, double seconds, std::size_t capacity) {
    Rig rig;
    Ring<Sample> ring(capacity);
    Reader reader(ring);
    const std::atomic<bool> stop{false};
    const ServoSettings settings{period, Pace::fast, seconds};
    const Result<LoopStatistics> statistics = runServoLoop(stylus, rig.step, ring, settings, stop);
    return {*statistics, reader.finish()};
}

} // namespace

class TestServoLoop : public QObject {
    Q_OBJECT
private slots:
    void fastGivesOneSampleForEachPeriodAndLosesNone() {
        CirclingStylus stylus;
        // A ring far smaller than the run: the loop has to wait for the reader.
        const LoopRun run = runFast(stylus, 3.0, 32);
        QCOMPARE(run.statistics.ticks, std::uint64_t{3000});
        QCOMPARE(run.samples.size(), std::size_t{3000});
        QVERIFY(std::abs(run.statistics.simulatedSeconds - 3.0) < 1e-9);
        for (std::size_t i = 0; i < run.samples.size(); ++i) {
            QCOMPARE(run.samples[i].tick, std::uint64_t{i});
            QVERIFY(std::abs(run.samples[i].time - static_cast<double>(i) * period) < 1e-9);
        }
        QVERIFY(stylus.largestForce > 0.5);
        QCOMPARE(stylus.lastForce, glm::dvec3(0.0));
        QCOMPARE(stylus.writes, 3001);
        QVERIFY(run.statistics.workP50 <= run.statistics.workP99);
        QVERIFY(run.statistics.workP99 <= run.statistics.workP999);
        QVERIFY(run.statistics.workP999 <= run.statistics.workMaximum);
        QVERIFY(run.statistics.cpuP50 > 0.0);
    }

    void theSameHandGivesTheSameRecording() {
        CirclingStylus one, other;
        const LoopRun a = runFast(one, 1.5, 4096), b = runFast(other, 1.5, 64);
        QCOMPARE(a.samples.size(), b.samples.size());
        for (std::size_t i = 0; i < a.samples.size(); ++i) {
            QCOMPARE(a.samples[i].proxy.tip, b.samples[i].proxy.tip);
            QCOMPARE(a.samples[i].force, b.samples[i].force);
            QCOMPARE(a.samples[i].removed[0].units, b.samples[i].removed[0].units);
        }
    }

    void endsWhenTheStylusHasFinished() {
        CirclingStylus stylus(0.5);
        const LoopRun run = runFast(stylus, 1e9, 4096);
        QCOMPARE(run.statistics.ticks, std::uint64_t{501});
        QCOMPARE(stylus.lastForce, glm::dvec3(0.0));
    }

    void realtimeFollowsTheClock_data() {
        QTest::addColumn<double>("rate");
        for (const double rate : {1000.0, 2000.0, 4000.0}) QTest::addRow("%g Hz", rate) << rate;
    }
    void realtimeFollowsTheClock() {
        QFETCH(double, rate);
        const double period = 1.0 / rate;
        HapticSettings wanted = Rig::settings();
        wanted.tickPeriod = period;
        Rig rig(wanted);
        CirclingStylus stylus;
        Ring<Sample> ring(4096);
        const std::atomic<bool> stop{false};
        const Result<LoopStatistics> result = runServoLoop(stylus, rig.step, ring, {period, Pace::realtime, 0.4}, stop);
        QVERIFY(result.hasValue());
        // However busy the machine is: each edge of the clock was either served or counted as missed.
        QCOMPARE(result->ticks + result->missed,
                 static_cast<std::uint64_t>(std::llround(result->simulatedSeconds / period)));
        QVERIFY(result->simulatedSeconds >= 0.4 - period);
        QVERIFY(result->wallSeconds >= 0.399);
        QCOMPARE(ring.size(), static_cast<std::size_t>(result->ticks));
        QCOMPARE(stylus.lastForce, glm::dvec3(0.0));
        std::vector<Sample> samples(ring.size());
        ring.pop(samples);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const double periods = (samples[i].time - samples[i - 1].time) / period;
            QVERIFY(periods > 0.999 && std::abs(periods - std::round(periods)) < 1e-6);
        }
    }

    void realtimeNeverLosesASampleSilently() {
        Rig rig;
        CirclingStylus stylus;
        Ring<Sample> ring(64); // without a reader
        const std::atomic<bool> stop{false};
        const Result<LoopStatistics> result = runServoLoop(stylus, rig.step, ring, {period, Pace::realtime, 5.0}, stop);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::recordingOverflow);
        QCOMPARE(result.error().subject, std::string("64"));
        QCOMPARE(ring.size(), std::size_t{64});
        QCOMPARE(stylus.lastForce, glm::dvec3(0.0));
    }

    void stopsWhenTold_data() {
        QTest::addColumn<bool>("fast");
        QTest::newRow("in real time") << false;
        QTest::newRow("fast, waiting for a reader that does not come") << true;
    }
    void stopsWhenTold() {
        QFETCH(bool, fast);
        Rig rig;
        CirclingStylus stylus;
        Ring<Sample> ring(fast ? 64 : 1 << 16);
        std::atomic<bool> stop{false};
        std::thread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            stop = true;
        });
        const Result<LoopStatistics> result =
            runServoLoop(stylus, rig.step, ring, {period, fast ? Pace::fast : Pace::realtime, 1e9}, stop);
        later.join();
        QVERIFY(result.hasValue());
        QCOMPARE(static_cast<std::size_t>(result->ticks), ring.size());
        QCOMPARE(stylus.lastForce, glm::dvec3(0.0));
    }

    /// A sink that asks the loop to stand gets no ticks meanwhile, and the hand no force; such time does not count as
    /// missed.
    void standsWithoutForceWhenTheSinkAsks_data() {
        QTest::addColumn<int>("pace");
        QTest::newRow("fast") << int(Pace::fast);
        QTest::newRow("in real time") << int(Pace::realtime);
    }
    void standsWithoutForceWhenTheSinkAsks() {
        QFETCH(int, pace);
        struct StandingSink final : TickSink {
            AtEdge edge() noexcept override {
                const bool stands = ticks == 50 && stood < 20;
                if (stands && stood++ > 0) zeroForce = zeroForce && stylus.lastForce == glm::dvec3(0.0);
                return stands ? AtEdge::stand : AtEdge::tick;
            }
            void tick(const Sample& sample, const TickTiming& timing) noexcept override {
                ordered = ordered && sample.tick == ticks && timing.missed >= missed && timing.period > 0.0;
                missed = timing.missed;
                ++ticks;
            }
            CirclingStylus stylus;
            std::uint64_t ticks = 0, missed = 0;
            int stood = 0;
            bool zeroForce = true, ordered = true;
        } sink;
        Rig rig;
        const std::atomic<bool> stop{false};
        const Result<LoopStatistics> result =
            runServoLoop(sink.stylus, rig.step, sink, {period, static_cast<Pace>(pace), 0.15}, stop);
        QVERIFY(result.hasValue());
        QCOMPARE(sink.stood, 20);
        QVERIFY(sink.zeroForce && sink.ordered);
        QCOMPARE(result->ticks, sink.ticks);
        const auto edges = static_cast<std::uint64_t>(std::llround(result->simulatedSeconds / period));
        if (pace == int(Pace::realtime))
            QVERIFY(result->ticks + result->missed + 20 <= edges); // each time it stood cost at least one edge
        else
            QCOMPARE(result->ticks, edges);
    }

    /// Time lapse: the hand's time runs ahead of the clock, tick by tick of the nominal period.
    void timeLapseMakesManyTicksAtAnEdge() {
        Rig rig;
        CirclingStylus stylus;
        Ring<Sample> ring(1024);
        const std::atomic<bool> stop{false};
        ServoSettings settings{period, Pace::realtime, 0.4};
        settings.ticksPerEdge = 8;
        const Result<LoopStatistics> result = runServoLoop(stylus, rig.step, ring, settings, stop);
        QVERIFY(result.hasValue());
        QCOMPARE(result->ticks, std::uint64_t{400});
        QVERIFY(std::abs(result->simulatedSeconds - 0.4) < 1e-9);
        QVERIFY(result->wallSeconds >= 0.048); // fifty edges
        std::vector<Sample> samples(ring.size());
        ring.pop(samples);
        for (const Sample& sample : samples)
            QVERIFY(std::abs(sample.time - static_cast<double>(sample.tick) * period) < 1e-9);
        settings.ticksPerEdge = 0;
        QCOMPARE(runServoLoop(stylus, rig.step, ring, settings, stop).error().code, ErrorCode::argumentInvalid);
    }

    /// The figures of a running loop are those of its ticks.
    void liveFiguresFollowTheTicks() {
        const auto figures = std::make_unique<LoopFigures>();
        TickTiming timing;
        int posted = 0;
        for (int i = 0; i < 2000; ++i) {
            timing.over = 5'000'000'000 + std::int64_t{i} * 2'000'000; // 500 Hz
            timing.work = i % 100 == 0 ? 90'000 : 20'000;
            timing.cpu = 10'000;
            timing.missed = static_cast<std::uint64_t>(i);
            posted += figures->add(timing) ? 1 : 0;
        }
        QVERIFY(posted >= 14 && posted <= 16); // four times a second
        QVERIFY(std::abs(figures->newest().rateHz - 500.0) < 1.0);
        QVERIFY(std::abs(figures->newest().workP999 - 90.0) < 3.0);
        QVERIFY(std::abs(figures->newest().cpuP999 - 10.0) < 0.4);
        QVERIFY(figures->newest().ticks >= 1875 && figures->newest().missed + 1 == figures->newest().ticks);
    }

    void refusesAPeriodThatIsNone() {
        Rig rig;
        CirclingStylus stylus;
        Ring<Sample> ring(64);
        const std::atomic<bool> stop{false};
        for (double wrong : {0.0, -0.001, std::numeric_limits<double>::quiet_NaN()}) {
            const auto result = runServoLoop(stylus, rig.step, ring, {wrong, Pace::fast, 1.0}, stop);
            QVERIFY(!result);
            QCOMPARE(result.error().code, ErrorCode::argumentInvalid);
        }
    }

    void quantilesAreThoseOfTheSortedDurations() {
        QVERIFY(rc::check([](const std::vector<std::uint32_t>& random, std::uint8_t shift) {
            RC_PRE(!random.empty());
            std::vector<std::int64_t> durations;
            for (std::uint32_t value : random) durations.push_back(static_cast<std::int64_t>(value) << (shift % 20));
            auto histogram = std::make_unique<DurationHistogram>();
            for (std::int64_t value : durations) histogram->add(value);
            std::sort(durations.begin(), durations.end());
            for (double share : {0.01, 0.5, 0.9, 0.999, 1.0}) {
                const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(durations.size())));
                const double exact = static_cast<double>(durations[rank - 1]) * 1e-3;
                const double found = histogram->quantileMicroseconds(share);
                RC_ASSERT(found >= exact * (1.0 - 1e-12));
                RC_ASSERT(found <= exact * (1.0 + 1.0 / 32.0) + 1e-12);
            }
        }));
    }
};

BURIN_TEST(TestServoLoop, NoApplication)

} // namespace burin::tst_servo_loop

#include "tst_servo_loop.moc"
