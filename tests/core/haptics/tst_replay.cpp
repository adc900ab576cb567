// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/own_stylus.h"
#include "tests/core/haptics/replayed_session.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_replay {

using namespace burin::test;

namespace {

/// A hand that plunges into the stock, circles, presses on the part below it, and from time to time does what hands and
/// devices should not do. It advances from reading to reading, however late they are.
StylusState roughHand(double time, int reading) {
    StylusState state;
    state.time = time;
    const double moved = 0.001 * reading, depth = std::min(6.0 * std::max(0.0, moved - 0.05), 14.0);
    state.pose.position = {6.0 * std::cos(9.0 * moved), 6.0 * std::sin(9.0 * moved), 2.0 - 2.5 * depth};
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
    HapticSettings settings = Rig::settings();
    settings.rampSeconds = 0.02;
    return settings;
}

bool isEventful(const SessionEvents& events) {
    return events.cut > 50 && events.held > 20 && events.guided > 50 && events.faults > 3 && events.felt > 20;
}

/// Records a session with a stylus of the given kind, and replays it from its trace.
void playTwice(bool selfPaced, double seconds, SessionEvents& events) {
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
    CalledHand called;
    OwnStylus own(ownDescription(), roughHand);
    const StylusHandle stylus = selfPaced ? StylusHandle(own) : StylusHandle(called);
    const RecordedSession original = recordSession(stylus, settings(), file, seconds);
    const std::string difference = differenceOf(original, replaySession(settings(), file));
    QVERIFY2(difference.empty(), difference.c_str());
    events = eventsOf(original.samples);
}

} // namespace

/// The replay of a trace of any kind of device is bitwise identical to the session: tool poses, removal, forces;
/// through gaps, jumps and invalid readings.
class TestReplay : public QObject {
    Q_OBJECT
private slots:
    void aTraceIsPlayedToTheBit_data() {
        QTest::addColumn<bool>("selfPaced");
        QTest::newRow("called by us") << false;
        QTest::newRow("self-paced") << true;
    }
    void aTraceIsPlayedToTheBit() {
        QFETCH(bool, selfPaced);
        SessionEvents events;
        for (const double seconds : {1.5, 4.0, 10.0}) { // a busy machine has run few ticks by then
            playTwice(selfPaced, seconds, events);
            if (QTest::currentTestFailed() || isEventful(events)) return;
        }
        QFAIL(qPrintable(QString("%1 cut, %2 held, %3 guided, %4 faults, %5 felt: the session was none")
                             .arg(events.cut)
                             .arg(events.held)
                             .arg(events.guided)
                             .arg(events.faults)
                             .arg(events.felt)));
    }

    /// Without the changes that the session was told about, the result differs: otherwise the test above would prove
    /// nothing.
    void whatWasToldInBetweenMatters() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("trace.csv").toStdString(),
                                    bare = folder.filePath("bare.csv").toStdString();
        CalledHand hand;
        const RecordedSession original = recordSession(hand, settings(), file, 1.0);
        const auto trace = readTrace(file);
        QVERIFY(trace);
        QVERIFY(trace->changes.size() >= 15);
        QVERIFY(writeTrace(bare, trace->readings));
        QVERIFY(differenceOf(original, replaySession(settings(), bare)).starts_with("tick "));
    }

    /// A trace that cannot be replayed is refused, not played as something else.
    void anotherWorkpieceIsRefused() {
        const auto refused = [](const std::string& line) {
            const std::string text = std::string(tickTraceMark) + "\n" + std::string(tickTraceHeader) +
                                     "\n0,1,2,3,1,0,0,0,0,0.001,1,0\n!" + line + "\n";
            auto trace = parseTrace(text, "trace.csv");
            return trace ? sessionTraceOf(std::move(*trace), "trace.csv") : Result<SessionTrace>(trace.error());
        };
        const auto changed = refused(R"({"workpiece_changed": true})");
        QVERIFY(!changed);
        QCOMPARE(changed.error().code, ErrorCode::traceInvalid);
        QCOMPARE(changed.error().place, std::string("line 4"));
        for (const char* line :
             {"", "{}", "x", R"({"allowance_mm": -1})", R"({"allowance_mm": 1, "levels": 2})", R"({"levels": 0.5})",
              R"({"guides": [], "step_button": 0})", R"({"spindle_released": 1})", R"({"take_begins": false})",
              R"({"layer": -1, "on": true})", R"({"workspace": {}})", R"({"stroke": "gone"})",
              R"({"curve": 1, "points": 2, "points_mm": [0,0,0,1,0,0], "tangents": [1,0,0,1,0,0]})",
              R"({"curve": 0, "points": 2, "points_mm": [0,0,0,0,0,0], "tangents": [1,0,0,1,0,0]})",
              R"({"curve": 0, "points": 2000000000, "points_mm": [], "tangents": []})"}) {
            const auto wrong = refused(line);
            QVERIFY2(!wrong, line);
            QCOMPARE(wrong.error().code, ErrorCode::traceInvalid);
            QCOMPARE(wrong.error().place, std::string("line 4"));
        }
        QVERIFY(refused(R"({"curve": 0, "points": 2, "points_mm": [0,0,0,1,0,0], "tangents": [1,0,0,1,0,0]})"));
    }

    void aTraceIsWrittenWholeOrNotAtAll() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
        SampleLog log;
        {
            auto recorder = TraceRecorder::begin(file, log);
            QVERIFY(recorder);
            (*recorder)->tick({}, {});
        }
        QVERIFY(QDir(folder.path()).isEmpty());
        QCOMPARE(TraceRecorder::begin(file / "none", log).error().code, ErrorCode::fileNotWritable);
    }

    /// The loop is informed of a disk that does not keep up before any data are lost.
    void aFullRingIsTold() {
        QTemporaryDir folder;
        SampleLog log;
        auto recorder = TraceRecorder::begin(folder.filePath("trace.csv").toStdString(), log);
        QVERIFY(recorder);
        TickTiming timing;
        timing.period = 0.001;
        int ticks = 0;
        while ((*recorder)->edge() == AtEdge::tick && ticks < 100'000) {
            (*recorder)->tick({}, timing);
            ++ticks;
        }
        auto written = (*recorder)->finish();
        QVERIFY(written && written->putInPlace()); // either ring may have filled first: the log's or the recorder's own
        const auto read = readTrace(folder.filePath("trace.csv").toStdString());
        QVERIFY(read);
        QCOMPARE(read->readings.size(), static_cast<std::size_t>(ticks));
    }
};

BURIN_TEST(TestReplay, NoApplication)

} // namespace burin::tst_replay

#include "tst_replay.moc"
