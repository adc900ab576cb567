// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/exchange.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/board.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>
#include <rapidcheck.h>

#include <cmath>
#include <optional>
#include <random>

namespace burin::tst_open_stylus_exchange {

using namespace burin::openstylus;
using test::Board;

namespace {

Identity identityOf(const Board& board) {
    Identity identity;
    if (decodeFeature(board.feature(), identity) != IdentityFault::none) std::abort(); // error in the test's own set-up
    return identity;
}

/// Host and board connected without a bus: in each period a reading goes up and an answer comes down, unless a test
/// loses one.
struct Line {
    explicit Line(const open_stylus_limits& limits = Board::limits())
        : board(
              [this](const Board::Report& report) {
                  pending = report;
                  return true;
              },
              limits)
        , exchange(identityOf(board)) {}

    Exchange::Outcome period(const Wrench& wrench = {}, bool readingArrives = true, bool answerArrives = true) {
        now += 0.001;
        board.step();
        Exchange::Outcome outcome = Exchange::Outcome::old;
        if (readingArrives) outcome = exchange.take(pending, now);
        if (outcome == Exchange::Outcome::reading) {
            answer = exchange.answer(wrench, now);
            if (answerArrives) board.receive({answer.begin(), answer.end()});
        }
        return outcome;
    }
    /// Runs until forces flow.
    void begin() {
        for (int i = 0; i < 10 && !exchange.state().valid; ++i) period();
    }
    double boardForce(int axis) const { return board.force[static_cast<std::size_t>(axis)] / 65536.0; }

    double now = 100.0;
    Board::Report pending;
    std::array<std::uint8_t, outputSize> answer{};
    Board board;
    Exchange exchange;
};

std::vector<DeviceFault> faultsOf(Exchange& exchange) {
    std::vector<DeviceFault> faults;
    while (const auto fault = exchange.faults().take()) faults.push_back(*fault);
    return faults;
}

} // namespace

class TestOpenStylusExchange : public QObject {
    Q_OBJECT
private slots:
    void motorsComeOnOnlyAfterOff() {
        Line line;
        line.period({{1.0, 0.0, 0.0}, {}});
        QVERIFY(!line.exchange.state().valid && !line.board.motorsOn);
        QCOMPARE(line.answer[1], std::uint8_t{0}); // off
        int periods = 1;
        for (; periods < 20 && !line.exchange.state().valid; ++periods) line.period({{1.0, 0.0, 0.0}, {}});
        QCOMPARE(periods, Exchange::armingReports + 2); // offs, the first on, and the reading that reports it
        QVERIFY(line.board.motorsOn);
        QCOMPARE(line.boardForce(0), 1.0); // the answer to the first valid reading
        QVERIFY(faultsOf(line.exchange).empty());
    }

    /// A device that did not receive "off" still reports on. Whatever the loop would send it meanwhile is replaced by
    /// zero, so the loop must know of it; otherwise its force would be there at once afterwards.
    void whileTheMotorsAreAskedOffNoReadingIsValid() {
        Line line;
        line.begin();
        QVERIFY(line.exchange.state().valid);
        line.exchange.cut();
        for (int off = 0; off < Exchange::armingReports; ++off) {
            line.period({{1.0, 0.0, 0.0}, {}}, true, false); // lost in transit
            QVERIFY(line.board.motorsOn);
            QCOMPARE(line.answer[1], std::uint8_t{0});
            QVERIFY(off == 0 || !line.exchange.state().valid);
        }
        line.period({{1.0, 0.0, 0.0}, {}});
        QVERIFY(line.exchange.state().valid);
        QCOMPARE(line.boardForce(0), 1.0);
    }

    void aHostThatOnlyEverSaysOnGetsNothing() {
        Board board([](const Board::Report&) { return true; });
        for (std::uint16_t number = 1; number < 1000; ++number) {
            const auto on = encodeOutput({number, 0, true, {{1.0, 0.0, 0.0}, {}}});
            QVERIFY(board.receive({on.begin(), on.end()}));
            board.step();
            QVERIFY(!board.motorsOn);
        }
    }

    void forceFollowsAtOnce() {
        Line line;
        line.begin();
        for (int i = 1; i <= 100; ++i) {
            const Wrench wrench{{0.01 * i, -0.02 * i, 0.0}, {0.5 * i, 0.0, -0.25 * i}};
            line.period(wrench);
            QVERIFY(std::abs(line.boardForce(1) - wrench.force.y) <= 0x1.0p-17);
            QVERIFY(std::abs(line.board.torque[2] / 65536.0 - wrench.torque.z) <= 0x1.0p-17);
        }
    }

    void noForceIsEverBeyondTheLimits() {
        const auto most = static_cast<std::uint64_t>(Board::limits().maximum_force) * Board::limits().maximum_force;
        QVERIFY(rc::check("force and torque, whatever the client asks", [most] {
            Line line;
            line.begin();
            Wrench wrench;
            for (int axis = 0; axis < 3; ++axis) {
                const int kind = *rc::gen::inRange(0, 6);
                const double value = *rc::gen::inRange(-1000000, 1000000) * 1e-4;
                wrench.force[axis] = kind == 0 ? std::nan("") : kind == 1 ? HUGE_VAL : kind == 2 ? 1e308 : value;
                wrench.torque[axis] = 10.0 * value;
            }
            line.period(wrench);
            RC_ASSERT(line.board.largestForceSquared <= most);
            const glm::dvec3 sent(line.boardForce(0), line.boardForce(1), line.boardForce(2));
            if (!isFinite(wrench.force)) {
                RC_ASSERT(sent == glm::dvec3(0.0));
            } else if (const double length = glm::length(wrench.force); length > 3.0 && std::isfinite(length)) {
                // shortened, with its direction kept
                RC_ASSERT(glm::length(sent) > 3.0 - 1e-4);
                RC_ASSERT(glm::length(glm::cross(sent, wrench.force)) < 1e-4 * length);
                RC_ASSERT(glm::dot(sent, wrench.force) > 0.0);
            }
        }));
    }

    void theBoardShortensWhatTheHostDoesNot() {
        Board board([](const Board::Report&) { return true; });
        std::mt19937 random(11);
        std::uniform_real_distribution<double> force(-30000.0, 30000.0);
        const auto most = static_cast<std::uint64_t>(Board::limits().maximum_force) * Board::limits().maximum_force;
        for (std::uint16_t number = 0; number < 5000; ++number) {
            const glm::dvec3 wanted(force(random), force(random), force(random));
            const auto report = encodeOutput({number, 0, number > 0, {wanted, {}}});
            QVERIFY(board.receive({report.begin(), report.end()}));
            QVERIFY(board.largestForceSquared <= most);
            if (number == 0) continue;
            const glm::dvec3 rendered(board.force[0], board.force[1], board.force[2]);
            QVERIFY(glm::length(rendered) > 65536.0 * 3.0 - 4.0);
            QVERIFY(glm::length(glm::cross(rendered, wanted)) < 4.0 * glm::length(wanted));
        }
    }

    void theWatchdogCutsTheMotorsWhenTheHostFallsSilent() {
        Line line;
        line.begin();
        line.period({{1.0, 0.0, 0.0}, {}});
        QVERIFY(line.board.motorsOn);
        int silent = 0;
        for (; line.board.motorsOn && silent < 100; ++silent) line.period({}, true, false);
        QCOMPARE(silent, 21); // the first step beyond 20 ms
        QVERIFY(line.board.force == (std::array<std::int32_t, 3>{}));
    }

    void afterAFaultForcesComeBackByThemselvesThroughOff() {
        Line line;
        line.begin();
        for (int i = 0; i < 25; ++i) line.period({{1.0, 0.0, 0.0}, {}}, true, false);
        QVERIFY(!line.exchange.state().valid);
        QCOMPARE(faultsOf(line.exchange), std::vector{DeviceFault::watchdog});
        line.period({{1.0, 0.0, 0.0}, {}});
        QVERIFY(!line.board.motorsOn); // an off came first
        line.begin();
        QVERIFY(line.exchange.state().valid);
        line.period({{1.0, 0.0, 0.0}, {}});
        QCOMPARE(line.boardForce(0), 1.0);
        QVERIFY(faultsOf(line.exchange).empty());
    }

    void eachFaultOfTheBoardIsToldOnceAndCutsTheMotors_data() {
        QTest::addColumn<int>("bit");
        QTest::addColumn<DeviceFault>("fault");
        QTest::newRow("not calibrated") << int{OPEN_STYLUS_NOT_CALIBRATED} << DeviceFault::notCalibrated;
        QTest::newRow("too hot") << int{OPEN_STYLUS_OVERHEATED} << DeviceFault::overheated;
        QTest::newRow("overload") << int{OPEN_STYLUS_OVERLOADED} << DeviceFault::overloaded;
        QTest::newRow("too fast") << int{OPEN_STYLUS_TOO_FAST} << DeviceFault::tooFast;
        QTest::newRow("stop button") << int{OPEN_STYLUS_STOPPED} << DeviceFault::stopped;
        QTest::newRow("mechanism") << int{OPEN_STYLUS_MECHANISM} << DeviceFault::mechanism;
    }
    void eachFaultOfTheBoardIsToldOnceAndCutsTheMotors() {
        QFETCH(int, bit);
        QFETCH(DeviceFault, fault);
        Line line;
        line.begin();
        line.board.reading.faults = static_cast<std::uint16_t>(bit);
        for (int i = 0; i < 50; ++i) {
            line.period({{1.0, 0.0, 0.0}, {}});
            QVERIFY(!line.board.motorsOn && !line.exchange.state().valid);
        }
        QCOMPARE(faultsOf(line.exchange), std::vector{fault});
        line.board.reading.faults = 0;
        line.begin();
        QVERIFY(line.exchange.state().valid && line.board.motorsOn);
    }

    void aBoardThatIsMovedTooFastStopsItsMotors() {
        Line line;
        line.begin();
        line.board.moveTo(0.9, 0.0, 0.0); // 900 mm/s
        line.period();
        QVERIFY(line.board.motorsOn);
        line.board.moveTo(2.0, 0.0, 0.0); // 1100 mm/s
        line.period();
        QVERIFY(!line.board.motorsOn);
        QCOMPARE(faultsOf(line.exchange), std::vector{DeviceFault::tooFast});
    }

    void lostReadingsAreCountedAndOldOnesRefused() {
        Line line;
        line.begin();
        const std::uint64_t before = line.exchange.health().readings;
        for (int i = 0; i < 5; ++i) line.period({}, false);
        QCOMPARE(line.period(), Exchange::Outcome::reading);
        QCOMPARE(line.exchange.health().lost, std::uint64_t{5});
        QCOMPARE(line.exchange.health().readings, before + 1);
        QCOMPARE(line.exchange.take(line.pending, line.now), Exchange::Outcome::old); // the same again
        QCOMPARE(line.exchange.health().repeated, std::uint64_t{1});
        QCOMPARE(line.exchange.health().lost, std::uint64_t{5});
    }

    void numbersMayWrapAround() {
        Line line;
        for (int i = 0; i < 70000; ++i) QCOMPARE(line.period(), Exchange::Outcome::reading);
        QCOMPARE(line.exchange.health().lost, std::uint64_t{0});
        QCOMPARE(line.exchange.health().readings, std::uint64_t{70000});
    }

    void aBoardThatStartedAnewIsHeardAgain() {
        Line line;
        for (int i = 0; i < 1000; ++i) line.period();
        Board::Report sent;
        Board anew([&sent](const Board::Report& report) {
            sent = report;
            return true;
        });
        int unheard = 0;
        for (;; ++unheard) {
            anew.step();
            if (line.exchange.take(sent, line.now += 0.001) == Exchange::Outcome::reading) break;
            QVERIFY(unheard < 20);
        }
        QCOMPARE(unheard, Exchange::backwardsInARow - 1);
        QVERIFY(!line.exchange.state().valid); // its motors are off
    }

    void timeIsTheBoardsNotTheBuses() {
        Line line;
        line.begin();
        std::mt19937 random(5);
        std::uniform_real_distribution<double> late(0.0, 0.0009);
        double before = line.exchange.state().time;
        for (int i = 0; i < 1000; ++i) {
            line.now += 0.001;
            line.board.step(997); // its clock is slightly slow
            QCOMPARE(line.exchange.take(line.pending, line.now + late(random)), Exchange::Outcome::reading);
            QVERIFY(std::abs(line.exchange.state().time - before - 997e-6) < 1e-12);
            before = line.exchange.state().time;
        }
    }

    void theClockMayWrapAroundAndNeverStandsStill() {
        Line line;
        line.board.microseconds = 0xffffff00U;
        line.begin();
        const double before = line.exchange.state().time;
        line.period();
        QVERIFY(std::abs(line.exchange.state().time - before - 0.001) < 1e-9);
        for (int i = 0; i < 10; ++i) {
            const double last = line.exchange.state().time;
            line.now += 0.001;
            line.board.step(0); // a clock that has stopped
            line.exchange.take(line.pending, line.now);
            QVERIFY(line.exchange.state().time > last);
        }
    }

    void silenceIsToldAsReadingsThatAreNotValid() {
        Line line;
        line.begin();
        const double before = line.exchange.state().time;
        const StylusState& silent = line.exchange.silence(0.003);
        QVERIFY(!silent.valid);
        QVERIFY(std::abs(silent.time - before - 0.003) < 1e-12);
        line.now += 0.003;
        line.period();
        QVERIFY(line.exchange.state().valid);
        QVERIFY(std::abs(line.exchange.state().time - before - 0.004) < 1e-9); // by the host's clock after a gap
    }

    void aBoardThatDoesNotHearIsAFault() {
        Line line;
        line.begin();
        const auto deaf = [&line] {
            const auto faults = faultsOf(line.exchange);
            return std::ranges::find(faults, DeviceFault::deaf) != faults.end();
        };
        int silent = 0;
        for (; silent < 300 && !deaf(); ++silent) line.period({}, true, false);
        QVERIFY(silent >= 100 && silent <= 103);
        for (int i = 0; i < 300; ++i) line.period({}, true, false);
        QVERIFY(!deaf()); // only once
        line.begin();
        for (int i = 0; i < 300; ++i) line.period({}, true, false);
        QVERIFY(deaf()); // because it had received something again
    }

    void theRoundTripIsMeasured() {
        Line line;
        line.begin();
        for (int i = 0; i < 10; ++i) line.period();
        QVERIFY(std::abs(line.exchange.health().roundTrip - 0.001) < 1e-9);
    }

    void manyDamagedReportsAreAFault() {
        Line line;
        line.begin();
        for (int i = 0; i < 9; ++i) line.exchange.take(Bytes(line.pending).first(47), line.now);
        QVERIFY(faultsOf(line.exchange).empty());
        line.exchange.take(Bytes(line.pending).first(47), line.now);
        QCOMPARE(faultsOf(line.exchange), std::vector{DeviceFault::damaged});
        QCOMPARE(line.exchange.health().damaged, std::uint64_t{10});
    }

    /// A million reports of a hostile device, every fifth one intact: no crash, no wrench above the limits, none with
    /// motors that are off, time never decreases.
    void hostileReportsDoNoHarm() {
        Line line;
        line.begin();
        std::mt19937 random(17);
        std::uniform_int_distribution<int> kind(0, 4), size(0, 80), byte(0, 255);
        double time = line.exchange.state().time;
        Board taker([](const Board::Report&) { return true; }); // renders what the host sends
        const auto most = static_cast<std::uint64_t>(Board::limits().maximum_force) * Board::limits().maximum_force;
        Board::Report report;
        for (int i = 0; i < 1000000; ++i) {
            report.resize(kind(random) == 0 ? static_cast<std::size_t>(size(random)) : inputSize);
            for (auto& one : report) one = static_cast<std::uint8_t>(byte(random));
            if (!report.empty()) report[0] = inputId;
            if (kind(random) == 0 && report.size() == inputSize) { // intact, with a valid rotation
                for (std::size_t at = 20; at < 36; ++at) report[at] = 0;
                report[23] = 0x40;
                const std::uint16_t crc = checksumOf(Bytes(report).first(46));
                report[46] = static_cast<std::uint8_t>(crc & 0xffU);
                report[47] = static_cast<std::uint8_t>(crc >> 8U);
            }
            line.exchange.take(report, line.now += 0.0001);
            const auto answer = line.exchange.answer({{1e6, -1e6, 1e6}, {1e9, 0.0, 0.0}}, line.now);
            taker.receive({answer.begin(), answer.end()});
            if (taker.largestForceSquared > most || !(line.exchange.state().time >= time))
                QFAIL(qPrintable(QStringLiteral("report %1").arg(i)));
            time = line.exchange.state().time;
        }
        QVERIFY(line.exchange.health().readings > 1000 && line.exchange.health().damaged > 1000);
    }

    void aTickAllocatesNothing() {
        Line line;
        line.begin();
        std::array<std::uint8_t, inputSize> report{};
        for (int i = 0; i < 100; ++i) {
            line.board.step();
            std::ranges::copy(line.pending, report.begin());
            const std::size_t before = allocationCount.load();
            line.exchange.take(report, line.now += 0.001);
            const auto answer = line.exchange.answer({{1.0, 2.0, 3.0}, {}}, line.now);
            line.exchange.silence(0.001);
            (void)line.exchange.health();
            (void)line.exchange.faults().take();
            QCOMPARE(allocationCount.load(), before);
            line.board.receive({answer.begin(), answer.end()});
        }
    }
};

BURIN_TEST(TestOpenStylusExchange, QCoreApplication)

} // namespace burin::tst_open_stylus_exchange

#include "tst_open_stylus_exchange.moc"
