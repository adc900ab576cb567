// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/resampled_stylus.h"
#include "core/haptics/servo_loop.h"
#include "core/haptics/trace_recorder.h"
#include "core/haptics/trace_stylus.h"
#include "core/recording/trace_file.h"
#include "tests/core/haptics/haptic_bench.h"
#include "tests/core/haptics/own_stylus.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace burin;
using namespace burin::test;

namespace {

/// A hand that plunges into the stock, circles, presses on the part below it, and does now and then what hands and
/// devices should not do.
StylusState roughHand(double time, int reading) {
    StylusState state;
    state.time = time;
    const double depth = std::min(6.0 * std::max(0.0, time - 0.05), 14.0);
    state.pose.position = {6.0 * std::cos(9.0 * time), 6.0 * std::sin(9.0 * time), 2.0 - 2.5 * depth};
    state.buttons = reading % 200 < 100 ? 1U : 3U;
    state.valid = reading % 131 != 60;
    if (reading % 167 == 90) state.pose.position.x += 30.0; // a jump
    if (reading % 211 == 100) state.pose.position.y = std::numeric_limits<double>::quiet_NaN();
    if (reading % 97 == 50) std::this_thread::sleep_for(std::chrono::milliseconds(reading % 2 == 0 ? 5 : 14)); // a gap
    return state;
}

class CalledHand final : public Stylus {
public:
    StylusDescription description() const override { return desktopStylus(); }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    StylusState read(double time) noexcept override { return roughHand(time, reading_++); }
    void write(const Wrench&) noexcept override {}

private:
    int reading_ = 0;
};

StylusDescription ownDescription() {
    StylusDescription description = desktopStylus();
    description.rate = {1000.0, "made up"};
    return description;
}

HapticSettings settings() {
    HapticSettings settings = Bench::settings();
    settings.rampSeconds = 0.02;
    return settings;
}

class Log final : public TickSink {
public:
    Log() { samples.reserve(1U << 14U); }
    AtEdge edge() noexcept override { return samples.size() < samples.capacity() ? AtEdge::tick : AtEdge::full; }
    void tick(const Sample& sample, const TickTiming&) noexcept override { samples.push_back(sample); }
    std::vector<Sample> samples;
};

/// What a session with a stylus did, and the trace that it left.
std::vector<Sample> record(const StylusHandle& stylus, const std::filesystem::path& file) {
    Bench bench(settings());
    Log log;
    auto recorder = TraceRecorder::begin(file, log);
    if (!recorder) return {};
    ServoSettings servo;
    servo.maximumSeconds = 1.5;
    const std::atomic<bool> stop{false};
    const auto ran = runServoLoop(stylus, bench.step, **recorder, servo, stop);
    return ran && (*recorder)->finish() ? std::move(log.samples) : std::vector<Sample>();
}

/// What the same session does, played again without a clock.
std::vector<Sample> replay(const std::filesystem::path& file) {
    const auto states = readTrace(file);
    if (!states) return {};
    TraceStylus stylus(*states, desktopStylus());
    if (!stylus.open()) return {};
    Bench bench(settings());
    Log log;
    ServoSettings servo;
    servo.pace = Pace::fast;
    const std::atomic<bool> stop{false};
    if (!runServoLoop(stylus, bench.step, log, servo, stop)) return {};
    return std::move(log.samples);
}

bool sameBits(const glm::dvec3& a, const glm::dvec3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

/// A trace of any kind of device gives the same session again, to the bit: where the tool was, what was cut, what was
/// felt; through gaps, jumps and readings that were none.
class TestReplay : public QObject {
    Q_OBJECT
private slots:
    void aTraceIsPlayedToTheBit_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("called by us") << 0;
        QTest::newRow("self-paced") << 1;
        QTest::newRow("resampled") << 2;
    }
    void aTraceIsPlayedToTheBit() {
        QFETCH(int, kind);
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
        CalledHand called;
        OwnStylus own(ownDescription(), roughHand);
        ResampledStylus resampled(std::make_unique<OwnStylus>(ownDescription(), roughHand));
        if (kind == 2) QVERIFY(resampled.open());
        const StylusHandle stylus = kind == 0   ? StylusHandle(called)
                                    : kind == 1 ? StylusHandle(own)
                                                : StylusHandle(static_cast<Stylus&>(resampled));
        const std::vector<Sample> original = record(stylus, file);
        resampled.close();
        const std::vector<Sample> again = replay(file);
        QVERIFY(original.size() > 100);
        QCOMPARE(again.size(), original.size());
        int cut = 0, held = 0, faults = 0, felt = 0;
        for (std::size_t i = 0; i < original.size(); ++i) {
            const Sample &a = original[i], &b = again[i];
            QCOMPARE(a.tick, b.tick);
            QVERIFY(std::memcmp(&a.time, &b.time, sizeof a.time) == 0);
            QVERIFY(sameBits(a.proxy.tip, b.proxy.tip));
            QVERIFY(sameBits(a.cuttingForce, b.cuttingForce));
            QVERIFY(std::memcmp(&a.reportedRemoval, &b.reportedRemoval, sizeof a.reportedRemoval) == 0);
            QVERIFY(std::memcmp(&a.removed, &b.removed, sizeof a.removed) == 0);
            // A force that came too late for the hand was withheld; that it was is said, and nothing follows from it.
            const bool late = (a.flags & sampleForceLate) != 0;
            if (!late) {
                QVERIFY(sameBits(a.force, b.force));
                QCOMPARE(a.flags, b.flags);
                QCOMPARE(a.buttons, b.buttons);
            }
            cut += a.removed[0].units > 0 ? 1 : 0;
            held += (a.flags & sampleOnBoundary) != 0 ? 1 : 0;
            faults += (a.flags & sampleStylusInvalid) != 0 ? 1 : 0;
            felt += glm::length(a.force) > 0.05 ? 1 : 0;
        }
        QVERIFY2(cut > 50 && held > 20 && faults > 3 && felt > 20, // or the session was none
                 qPrintable(QString("%1 %2 %3 %4").arg(cut).arg(held).arg(faults).arg(felt)));
    }

    void aTraceIsWrittenWholeOrNotAtAll() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
        Log log;
        {
            auto recorder = TraceRecorder::begin(file, log);
            QVERIFY(recorder);
            (*recorder)->tick({}, {});
        }
        QVERIFY(QDir(folder.path()).isEmpty());
        QCOMPARE(TraceRecorder::begin(file / "none", log).error().code, ErrorCode::fileNotWritable);
    }

    /// A disk that does not keep up is told to the loop before anything is lost.
    void aFullRingIsTold() {
        QTemporaryDir folder;
        Log log;
        auto recorder = TraceRecorder::begin(folder.filePath("trace.csv").toStdString(), log);
        QVERIFY(recorder);
        TickTiming timing;
        timing.period = 0.001;
        int ticks = 0;
        while ((*recorder)->edge() == AtEdge::tick && ticks < 100'000) {
            (*recorder)->tick({}, timing);
            ++ticks;
        }
        QVERIFY((*recorder)->finish()); // either ring filled first: the log's or the recorder's own
        const auto read = readTrace(folder.filePath("trace.csv").toStdString());
        QVERIFY(read);
        QCOMPARE(read->size(), static_cast<std::size_t>(ticks));
    }
};

QTEST_APPLESS_MAIN(TestReplay)
#include "tst_replay.moc"
