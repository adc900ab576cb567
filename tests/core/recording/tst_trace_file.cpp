// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/trace_file.h"
#include "core/recording/trace_playback.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstring>
#include <fstream>
#include <locale>
#include <random>
#include <rapidcheck.h>

namespace burin::tst_trace_file {

namespace {

const std::string header = std::string(traceHeader) + "\n";
const std::string ticks = std::string(tickTraceMark) + "\n" + std::string(tickTraceHeader) + "\n";
const std::string good = "0.001,1.5,-2,3e-3,1,0,0,0,0\n";

double randomDouble(std::mt19937_64& generator) {
    for (;;) { // any bit pattern that is a finite number
        const std::uint64_t bits = generator();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isfinite(value)) return value;
    }
}

} // namespace

class TraceFileTest final : public QObject {
    Q_OBJECT
private slots:
    void anyDoubleComesBackBitByBit();
    void readsWhatPeopleWrite_data();
    void readsWhatPeopleWrite();
    void namesTheLineThatIsWrong_data();
    void namesTheLineThatIsWrong();
    void noTextMakesItFail();
    void doesNotDependOnTheLocale();
    void namesAMissingFile();
    void leavesOutReadingsThatAreNotValid();
    void aFileIsPlayedAsItIsRead();
    void aFileWithAFaultIsNotPlayed();
    void aFileThatShrinksWhileItIsPlayedIsTold();
    void ticksComeBackWithTheirPeriods();
    void ticksThatAreWrongAreNamed_data();
    void ticksThatAreWrongAreNamed();
    void whatWasToldStandsBetweenTheReadings();
    void theFirstVersionIsReadAsEver();
};

/// Valid or not, whatever their times; a value that is not a number makes a reading invalid, and a missing period stays
/// missing.
void TraceFileTest::ticksComeBackWithTheirPeriods() {
    QVERIFY(rc::check([](std::uint64_t seed) {
        std::mt19937_64 generator(seed);
        std::vector<StylusState> states(20);
        for (StylusState& state : states) {
            state.time = randomDouble(generator);
            for (int axis = 0; axis < 3; ++axis) state.pose.position[axis] = randomDouble(generator);
            state.buttons = static_cast<std::uint32_t>(generator());
            state.valid = generator() % 3 != 0;
            state.period = std::abs(randomDouble(generator)) + std::numeric_limits<double>::min();
            state.motorHeat = std::abs(randomDouble(generator));
        }
        states[3].pose.position.y = std::numeric_limits<double>::quiet_NaN();
        states[4].period = std::numeric_limits<double>::infinity();
        states[5].period = 0.0;
        states[6].motorHeat = std::numeric_limits<double>::quiet_NaN();
        const auto read = parseTrace(formatTrace(states), "trace");
        RC_ASSERT(read.hasValue());
        RC_ASSERT(read->readings.size() == states.size());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const StylusState &wrote = states[i], &got = read->readings[i];
            RC_ASSERT(std::memcmp(&got.motorHeat, &wrote.motorHeat, sizeof(double)) == 0 || i == 6);
            RC_ASSERT(i != 6 || got.motorHeat == 0.0);
            RC_ASSERT(got.valid == (wrote.valid && i != 3));
            RC_ASSERT(got.buttons == wrote.buttons);
            if (i != 3) RC_ASSERT(std::memcmp(&got.pose, &wrote.pose, sizeof(Pose)) == 0);
            if (i == 4 || i == 5)
                RC_ASSERT(got.period < 0.0);
            else
                RC_ASSERT(std::memcmp(&got.period, &wrote.period, sizeof(double)) == 0);
        }
    }));
}

void TraceFileTest::ticksThatAreWrongAreNamed_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("no period") << QByteArray("0,1,2,3,1,0,0,0,0");
    QTest::newRow("a period that is none") << QByteArray("0,1,2,3,1,0,0,0,0,x,1,0");
    QTest::newRow("neither valid nor not") << QByteArray("0,1,2,3,1,0,0,0,0,0.001,2,0");
    QTest::newRow("a quaternion that is none") << QByteArray("0,1,2,3,0,0,0,0,0,0.001,1,0");
    QTest::newRow("no heat") << QByteArray("0,1,2,3,1,0,0,0,0,0.001,1");
    QTest::newRow("a heat that is none") << QByteArray("0,1,2,3,1,0,0,0,0,0.001,1,-0.1");
    QTest::newRow("too many values") << QByteArray("0,1,2,3,1,0,0,0,0,0.001,1,0,0");
}

void TraceFileTest::ticksThatAreWrongAreNamed() {
    QFETCH(QByteArray, line);
    const std::string text = ticks + "0,1,2,3,1,0,0,0,0,0.001,1,0.5\n" + line.toStdString() + "\n";
    const auto read = parseTrace(text, "trace");
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::traceInvalid);
    QCOMPARE(read.error().place, std::string("line 4"));
}

/// Lines after the mark are kept unchanged, with the reading that they precede.
void TraceFileTest::whatWasToldStandsBetweenTheReadings() {
    const std::string reading = "0,1,2,3,1,0,0,0,0,0.001,1,0\n";
    const auto read = parseTrace(ticks + "!{\"a\": 1}\n" + reading + "!b\n!\n" + reading + reading + "!c\r\n", "trace");
    QVERIFY(read);
    QCOMPARE(read->readings.size(), std::size_t{3});
    QCOMPARE(read->changes.size(), std::size_t{4});
    const struct {
        std::size_t reading, line;
        const char* text;
    } wanted[] = {{0, 3, "{\"a\": 1}"}, {1, 5, "b"}, {1, 6, ""}, {3, 9, "c"}};
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(read->changes[i].reading, wanted[i].reading);
        QCOMPARE(read->changes[i].line, wanted[i].line);
        QCOMPARE(read->changes[i].text, std::string(wanted[i].text));
    }
    QVERIFY(!parseTrace(header + "!c\n" + good, "trace")); // only a trace of ticks contains them
}

/// The previous format: no mark, no heat, nothing between the readings.
void TraceFileTest::theFirstVersionIsReadAsEver() {
    const std::string text = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons,period_s,valid\n0.5,1,2,3,1,0,0,0,7,0.001,1\n0,"
                             "0,0,0,1,0,0,0,0,-1,0\n";
    const auto read = parseTrace(text, "old.csv");
    QVERIFY(read);
    QCOMPARE(read->readings.size(), std::size_t{2});
    QVERIFY(read->changes.empty());
    QCOMPARE(read->readings[0].period, 0.001);
    QCOMPARE(read->readings[0].buttons, 7U);
    QCOMPARE(read->readings[0].motorHeat, 0.0);
    QVERIFY(read->readings[0].valid && !read->readings[1].valid);
    QVERIFY(!parseTrace(text + "!{}\n", "old.csv"));
    QCOMPARE(parseTrace("# Burin trace 3\n" + text, "new.csv").error().place, std::string("line 1"));
    QCOMPARE(parseTrace("# Burin trace 2\n" + text, "mixed.csv").error().place, std::string("line 2"));
}

void TraceFileTest::anyDoubleComesBackBitByBit() {
    QVERIFY(rc::check([](std::uint64_t seed) {
        std::mt19937_64 generator(seed);
        std::vector<StylusState> states(20);
        std::vector<double> times(states.size());
        for (double& time : times) time = randomDouble(generator);
        std::sort(times.begin(), times.end());
        RC_PRE(std::adjacent_find(times.begin(), times.end()) == times.end());
        for (std::size_t i = 0; i < states.size(); ++i) {
            states[i].time = times[i];
            for (int axis = 0; axis < 3; ++axis) states[i].pose.position[axis] = randomDouble(generator);
            const double angle = static_cast<double>(generator() >> 11);
            states[i].pose.rotation = glm::angleAxis(angle, glm::normalize(glm::dvec3(1.0, std::sin(angle), 0.3)));
            states[i].buttons = static_cast<std::uint32_t>(generator());
            states[i].valid = true;
        }
        const auto read = parseTrace(formatTrace(states), "trace");
        RC_ASSERT(read.hasValue());
        RC_ASSERT(read->readings.size() == states.size());
        for (std::size_t i = 0; i < states.size(); ++i) {
            RC_ASSERT(std::memcmp(&read->readings[i].time, &states[i].time, sizeof(double)) == 0);
            RC_ASSERT(std::memcmp(&read->readings[i].pose, &states[i].pose, sizeof(Pose)) == 0);
            RC_ASSERT(read->readings[i].buttons == states[i].buttons);
        }
    }));
}

void TraceFileTest::readsWhatPeopleWrite_data() {
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const std::string& text) {
        QTest::newRow(name) << QByteArray::fromStdString(text);
    };
    row("one reading", header + good);
    row("no last line end", header + "0,1,2,3,1,0,0,0,4294967295");
    row("line ends of another system", std::string(traceHeader) + "\r\n0,1,2,3,1,0,0,0,1\r\n");
    row("a rounded quaternion", header + "0,1,2,3,0.7071,0,0,0.7071,0\n");
    row("times before the start", header + "-1,1,2,3,1,0,0,0,0\n" + good);
}

void TraceFileTest::readsWhatPeopleWrite() {
    QFETCH(QByteArray, text);
    const auto read = parseTrace(text.toStdString(), "trace");
    QVERIFY(read);
    QVERIFY(!read->readings.empty() && read->readings.front().valid);
}

void TraceFileTest::namesTheLineThatIsWrong_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("place");
    const auto row = [](const char* name, const std::string& text, const char* place) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QString(place);
    };
    row("another header", "t,x,y,z\n" + good, "line 1");
    row("no header", good, "line 1");
    row("nothing but the header", header, "line 2");
    row("a value is missing", header + good + "0.002,1,2,3,1,0,0,0\n", "line 3");
    row("a value too many", header + good + "0.002,1,2,3,1,0,0,0,0,0\n", "line 3");
    row("a blank line", header + good + "\n" + good, "line 3");
    row("a word", header + "0,1,2,three,1,0,0,0,0\n", "line 2");
    row("a decimal comma", header + "0;1,5;2;3;1;0;0;0;0\n", "line 2");
    row("a space", header + "0, 1,2,3,1,0,0,0,0\n", "line 2");
    row("an empty value", header + "0,,2,3,1,0,0,0,0\n", "line 2");
    row("not a number", header + "0,nan,2,3,1,0,0,0,0\n", "line 2");
    row("endless", header + "0,inf,2,3,1,0,0,0,0\n", "line 2");
    row("too large", header + "0,1e999,2,3,1,0,0,0,0\n", "line 2");
    row("no unit quaternion", header + "0,1,2,3,1,1,0,0,0\n", "line 2");
    row("zero quaternion", header + "0,1,2,3,0,0,0,0,0\n", "line 2");
    row("negative buttons", header + "0,1,2,3,1,0,0,0,-1\n", "line 2");
    row("buttons with a fraction", header + "0,1,2,3,1,0,0,0,1.0\n", "line 2");
    row("too many buttons", header + "0,1,2,3,1,0,0,0,4294967296\n", "line 2");
    row("time stands still", header + good + good, "line 3");
    row("time goes back", header + good + "0,1,2,3,1,0,0,0,0\n", "line 3");
    row("a zero byte", header + std::string("0,1,2,3,1,0,0,0,\0\n", 19), "line 2");
}

void TraceFileTest::namesTheLineThatIsWrong() {
    QFETCH(QByteArray, text);
    QFETCH(QString, place);
    const auto read = parseTrace(text.toStdString(), "hand.csv");
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::traceInvalid);
    QCOMPARE(read.error().subject, std::string("hand.csv"));
    QCOMPARE(QString::fromStdString(read.error().place), place);
    QVERIFY(!read.error().detail.empty());
}

void TraceFileTest::noTextMakesItFail() {
    QVERIFY(rc::check("bytes of a good file changed at random: read, or refused with a line", [](std::uint64_t seed) {
        std::mt19937_64 generator(seed);
        std::string text = header + good + "0.002,1,2,3,1,0,0,0,7\n0.003,1,2,3,0,0,0,1,0\n";
        for (int changes = 1 + static_cast<int>(generator() % 4); changes > 0; --changes) {
            const std::size_t at = generator() % text.size();
            switch (generator() % 3) {
            case 0:
                text[at] = static_cast<char>(generator());
                break;
            case 1:
                text.erase(at, 1 + generator() % 5);
                break;
            default:
                text.insert(at, 1, ",.-+e0\n\r "[generator() % 9]);
            }
        }
        const auto read = parseTrace(text, "trace");
        if (read) {
            for (const StylusState& state : read->readings) RC_ASSERT(isFinite(state.pose.position));
        } else {
            RC_ASSERT(read.error().code == ErrorCode::traceInvalid);
            RC_ASSERT(read.error().place.starts_with("line "));
        }
    }));
    QCOMPARE(parseTrace("", "trace").error().code, ErrorCode::fileEmpty);
}

void TraceFileTest::doesNotDependOnTheLocale() {
    struct DecimalComma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    const std::string text = formatTrace(parseTrace(header + "1234.5,1.5,-2,3e-3,1,0,0,0,1000\n", "trace")->readings);
    std::locale::global(before);
    QCOMPARE(text, header + "1234.5,1.5,-2,0.003,1,0,0,0,1000\n");
}

void TraceFileTest::namesAMissingFile() {
    const QTemporaryDir folder;
    const auto read = readTrace(std::filesystem::path(folder.path().toStdString()) / "none.csv");
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::fileNotFound);
}

void TraceFileTest::leavesOutReadingsThatAreNotValid() {
    std::vector<Sample> samples(3);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].time = 0.001 * static_cast<double>(i);
        samples[i].device.position.x = static_cast<double>(i);
        samples[i].buttons = 2;
    }
    samples[1].flags = sampleStylusInvalid | sampleForcesOff;
    const std::vector<StylusState> states = traceOf(samples);
    QVERIFY(states[0].valid && !states[1].valid && states[2].valid);
    const auto read = parseTrace(formatTrace(states), "trace");
    QVERIFY(read);
    QCOMPARE(read->readings.size(), std::size_t{2});
    QCOMPARE(read->readings.back().pose.position.x, 2.0);
    QCOMPARE(read->readings.back().buttons, 2u);
}

namespace {

/// All the remaining states of a playback.
std::vector<StylusState> rest(TracePlayback& playback) {
    std::vector<StylusState> states;
    for (StylusState state; playback.next(state);) states.push_back(state);
    return states;
}

std::filesystem::path written(const QTemporaryDir& folder, const std::string& text) {
    std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "trace.csv";
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

} // namespace

/// More readings than are kept in memory, and lines that end within and at the ends of the parts in which the file is
/// read.
void TraceFileTest::aFileIsPlayedAsItIsRead() {
    const std::string line = "0.001,0.1,0.30000000000000004,-12.5,1,0,0,0,0,0.001,1,0";
    std::string text = std::string(tickTraceMark) + "\n" + std::string(tickTraceHeader) + "\n!{\"first\": 1}\n";
    std::size_t lines = 3;
    for (int i = 0; i < 60000; ++i, ++lines) {
        text += std::to_string(i) + line.substr(5) + (i % 3 == 0 ? "\r\n" : "\n");
        if (i % 20000 == 19999) {
            text += "!change " + std::to_string(i) + "\n";
            ++lines;
        }
    }
    text.pop_back(); // the last line may lack its line end
    const auto whole = parseTrace(text, "whole");
    QVERIFY(whole);
    const QTemporaryDir folder;
    Result<OpenedTrace> opened = openTrace(written(folder, text));
    QVERIFY(opened);
    QCOMPARE(opened->readings->extent().readings, std::uint64_t{60000});
    QVERIFY(opened->readings->extent().ticks);
    QCOMPARE(opened->changes.size(), std::size_t{4});
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(opened->changes[i].text, whole->changes[i].text);
        QCOMPARE(opened->changes[i].reading, whole->changes[i].reading);
        QCOMPARE(opened->changes[i].line, whole->changes[i].line);
    }
    for (int again = 0; again < 2; ++again) {
        QVERIFY(opened->readings->rewind());
        StylusState first;
        QVERIFY(opened->readings->next(first)); // a playback can be restarted
        QVERIFY(opened->readings->rewind());
        QCOMPARE(formatTrace(rest(*opened->readings)), formatTrace(whole->readings));
        QVERIFY(opened->readings->outcome());
    }
}

void TraceFileTest::aFileWithAFaultIsNotPlayed() {
    const std::string header = std::string(traceHeader) + "\n";
    for (const std::string& text :
         {std::string(), std::string("\n"), header, header + "0,0,0,0,1,0,0,0,0\n0,0,0,0,1,0,0,0,0\n",
          header + "0,0,0,0,1,0,0,0,0\n1,zero,0,0,1,0,0,0,0\n", std::string(tickTraceMark) + "\n"}) {
        const QTemporaryDir folder;
        const std::filesystem::path file = written(folder, text);
        const auto opened = openTrace(file);
        const auto read = readTrace(file);
        QVERIFY(!opened && !read);
        QCOMPARE(opened.error().code, read.error().code);
        QCOMPARE(opened.error().place, read.error().place);
        QCOMPARE(opened.error().detail, read.error().detail);
    }
    QCOMPARE(openTrace("/nowhere/trace.csv").error().code, ErrorCode::fileNotFound);
}

/// The player must be informed that the trace was incomplete.
void TraceFileTest::aFileThatShrinksWhileItIsPlayedIsTold() {
    std::string text = std::string(traceHeader) + "\n";
    for (int i = 0; i < 100; ++i) text += std::to_string(i) + ",0,0,0,1,0,0,0,0\n";
    const QTemporaryDir folder;
    const std::filesystem::path file = written(folder, text);
    Result<OpenedTrace> opened = openTrace(file);
    QVERIFY(opened);
    std::filesystem::resize_file(file, text.size() / 2 - 5);
    QVERIFY(opened->readings->rewind());
    QVERIFY(rest(*opened->readings).size() < 100);
    QVERIFY(!opened->readings->outcome());
}

BURIN_TEST(TraceFileTest, NoApplication)

} // namespace burin::tst_trace_file

#include "tst_trace_file.moc"
