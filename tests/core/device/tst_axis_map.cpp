// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/axis_calibration.h"
#include "core/device/axis_map_json.h"
#include "tests/core/device/axes_stylus.h"
#include "tests/test_program.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>
#include <random>

namespace burin::tst_axis_map {

using namespace burin::test;

/// Assignment and calibration of a device's axes.
class TestAxisMap : public QObject {
    Q_OBJECT

    static AxisUse anyUse() {
        AxisUse use;
        use.motion = static_cast<AxisMotion>(*rc::gen::inRange(0, 7));
        use.reversed = *rc::gen::arbitrary<bool>();
        use.gain = *rc::gen::inRange(5, 1000) * 0.01;
        use.deadZone = *rc::gen::inRange(0, 51) * 0.01;
        use.low = -0.01 * *rc::gen::inRange(50, 150);
        use.high = 0.01 * *rc::gen::inRange(50, 150);
        use.rest = 0.01 * *rc::gen::inRange(-50, 51);
        return use;
    }

private slots:
    /// Counted by hand: 10 % dead zone, rest at 0.1, ends at -0.9 and 0.6.
    void theShareIsLinearBeyondTheDeadZone_data() {
        QTest::addColumn<double>("reading");
        QTest::addColumn<double>("share");
        QTest::newRow("rest") << 0.1 << 0.0;
        QTest::newRow("upper end") << 0.6 << 0.8;
        QTest::newRow("beyond it") << 0.9 << 0.8;
        QTest::newRow("lower end") << -0.9 << -0.8;
        QTest::newRow("within the dead zone") << 0.149 << 0.0;
        QTest::newRow("half of the upper half") << 0.35 << 0.8 * 0.4 / 0.9;
        QTest::newRow("half of the lower half") << -0.4 << -0.8 * 0.4 / 0.9;
    }
    void theShareIsLinearBeyondTheDeadZone() {
        QFETCH(double, reading);
        QFETCH(double, share);
        AxisUse use{AxisMotion::x, false, 0.8, 0.1, -0.9, 0.1, 0.6};
        QVERIFY(std::abs(shareOf(use, reading) - share) < 1e-12);
        use.reversed = true;
        QVERIFY(std::abs(shareOf(use, reading) + share) < 1e-12);
        use.low = use.rest; // a trigger
        QCOMPARE(shareOf(use, -1.0), 0.0);
    }

    void noReadingLeavesTheRangeAndMoreIsNeverLess() {
        QVERIFY(rc::check([] {
            AxisUse use = anyUse();
            use.reversed = false;
            double before = -2.0;
            for (int i = -200; i <= 200; ++i) {
                const double share = shareOf(use, 0.01 * i);
                RC_ASSERT(share >= before && std::abs(share) <= 1.0);
                before = share;
            }
        }));
    }

    void axesOfOneMotionAddUp() {
        AxisMap map;
        map.axes[0].motion = map.axes[3].motion = AxisMotion::z;
        map.axes[3].reversed = true;
        map.axes[5] = {AxisMotion::b, false, 0.5};
        std::array<double, AxisMap::mostAxes> readings{};
        readings[0] = 0.75;
        readings[3] = 0.25;
        readings[5] = -1.0;
        readings[7] = 1.0; // assigned to nothing
        QCOMPARE(motionsOf(map, readings), (MotionShares{0.0, 0.0, 0.5, 0.0, -0.5, 0.0}));
        readings[3] = -0.75;
        QCOMPARE(motionsOf(map, readings)[2], 1.0); // limited
    }

    /// For every assignment and every set of pressed buttons, against the words of the declaration.
    void buttonsAreThoseOfTheSession() {
        QVERIFY(rc::check([] {
            AxisMap map;
            for (std::size_t i = 0; i < 6; ++i) map.buttons[i] = static_cast<ButtonAction>(*rc::gen::inRange(0, 5));
            const std::uint32_t pressed = *rc::gen::inRange(0U, 64U);
            bool mills = false, lifts = false;
            int firstMill = -1;
            for (int i = 0; i < 6; ++i) {
                const ButtonAction action = map.buttons[static_cast<std::size_t>(i)];
                const bool down = (pressed >> i & 1U) != 0;
                mills = mills || (down && action == ButtonAction::mill);
                lifts = lifts || (down && action == ButtonAction::lift);
                if (firstMill < 0 && action == ButtonAction::mill) firstMill = i;
            }
            const std::uint32_t bits = sessionButtons(map, pressed);
            RC_ASSERT(((bits & 1U) != 0) == (mills && !lifts));
            RC_ASSERT(liftPressed(map, pressed) == lifts);
            for (std::size_t bit = 1; bit < 32; ++bit) {
                if ((bits >> bit & 1U) == 0) continue;
                const std::size_t button = buttonOfBit(map, bit);
                RC_ASSERT((pressed >> button & 1U) != 0);
                RC_ASSERT(map.buttons[button] != ButtonAction::mill);
            }
        }));
    }

    void aMapIsReadAsItWasWritten() {
        QVERIFY(rc::check([] {
            const AxesStylus stylus;
            AxisMap map = stylus.axisMap();
            for (std::size_t i = 0; i < stylus.axes().size(); ++i) map.axes[i] = anyUse();
            map.buttons = {ButtonAction::undo, ButtonAction::mill, static_cast<ButtonAction>(*rc::gen::inRange(0, 11))};
            const Result<AxisMap> read = axisMapFromJson(toJson(map, mappableOf(stylus)), mappableOf(stylus));
            RC_ASSERT(read.hasValue());
            RC_ASSERT(*read == map);
        }));
    }

    void whatCannotBeIsRefused_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("motion") << QByteArray("\"x\"") << QByteArray("\"w\"");
        QTest::newRow("gain") << QByteArray("\"gain\":1.0") << QByteArray("\"gain\":0.01");
        QTest::newRow("dead zone") << QByteArray("\"dead_zone\":0.05") << QByteArray("\"dead_zone\":0.9");
        QTest::newRow("range") << QByteArray("\"low\":-1.0") << QByteArray("\"low\":0.5");
        QTest::newRow("no range") << QByteArray("\"high\":1.0") << QByteArray("\"high\":1e9");
        QTest::newRow("action") << QByteArray("\"mill\"") << QByteArray("\"explode\"");
        QTest::newRow("nothing mills") << QByteArray("\"mill\"") << QByteArray("\"undo\"");
        QTest::newRow("no JSON") << QByteArray("{") << QByteArray("");
    }
    void whatCannotBeIsRefused() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        AxesStylus stylus;
        QByteArray text = QByteArray::fromStdString(toJson(stylus.axisMap(), mappableOf(stylus)));
        QVERIFY(axisMapFromJson(text.toStdString(), mappableOf(stylus)).hasValue());
        QVERIFY2(text.contains(from), text.constData());
        text.replace(text.indexOf(from), from.size(), to);
        QVERIFY(!axisMapFromJson(text.toStdString(), mappableOf(stylus)).hasValue());
        QVERIFY(!assignKept(stylus, text.toStdString()).hasValue());
        QVERIFY(stylus.map == stylus.axisMap()); // nothing was assigned
    }

    /// An axis that the device no longer has is ignored, a new one keeps its default.
    void axesAreKnownByTheirNames() {
        const AxesStylus stylus;
        const Result<AxisMap> map = axisMapFromJson(
            R"({"axes":[{"axis":"gone","motion":"c","reversed":false,"gain":1,"dead_zone":0,"low":-1,"rest":0,"high":1},
                {"axis":"down","motion":"c","reversed":true,"gain":2,"dead_zone":0,"low":-1,"rest":0,"high":1}],
                "buttons":["mill"]})",
            mappableOf(stylus));
        QVERIFY(map.hasValue());
        QCOMPARE(map->axes[0], stylus.axisMap().axes[0]);
        QCOMPARE(map->axes[1], (AxisUse{AxisMotion::c, true, 2.0}));
    }

    /// Noise of a known deviation about a known rest; the dead zone is three deviations of it.
    void theCalibrationMeasuresRestNoiseAndEnds() {
        const AxesStylus stylus;
        AxisCalibration calibration(stylus.axes(), stylus.axisMap());
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0.0, 0.02);
        double sum = 0.0;
        std::vector<double> rests;
        for (int i = 0; i < 400; ++i) {
            rests.push_back(0.1 + noise(random));
            sum += rests.back();
            calibration.rest({{rests.back(), 0.0, -1.0, 0.3}, 0});
        }
        QVERIFY(!calibration.complete());
        for (int i = 0; i <= 100; ++i) // the first axis reaches both ends, the second only one
            calibration.move({{-0.8 + 0.015 * i, 0.009 * i, -1.0 + 0.018 * i, -0.5 + 0.013 * i}, 0});
        QVERIFY(calibration.complete());
        const double mean = sum / 400.0;
        double squares = 0.0;
        for (const double rest : rests) squares += (rest - mean) * (rest - mean);
        const double deviation = std::sqrt(squares / 399.0);
        const AxisMap map = calibration.proposed();
        QVERIFY(std::abs(map.axes[0].rest - mean) < 1e-9);
        QVERIFY(std::abs(map.axes[0].low + 0.8) < 1e-9 && std::abs(map.axes[0].high - 0.7) < 1e-9);
        QVERIFY(std::abs(map.axes[0].deadZone - 3.0 * deviation / (0.7 - mean)) < 1e-9);
        QVERIFY(std::abs(map.axes[0].deadZone - 0.1) < 0.02);
        QCOMPARE(map.axes[0].motion, AxisMotion::x); // the assignment stays
        QCOMPARE(map.axes[1].low, -1.0);             // not reached
        QCOMPARE(map.axes[1].high, 0.9);
        QCOMPARE(map.axes[1].rest, 0.0); // not reported before it was moved: rest and dead zone are those of before
        QCOMPARE(map.axes[1].deadZone, 0.05);
        QCOMPARE(map.axes[2].rest, -1.0); // a trigger
        QVERIFY(std::abs(map.axes[2].high - 0.8) < 1e-9 && map.axes[2].low == -1.0);
        QVERIFY(std::abs(map.axes[3].rest - 0.15) < 1e-9); // a slider, of which the middle counts
        QCOMPARE(map.axes[3].deadZone, 0.0);
        QVERIFY(checkAxisMap(map, mappableOf(stylus)).hasValue());
    }

    void axesAreWatchedUntilEnough() {
        AxesStylus stylus;
        stylus.reading.values[0] = 0.25;
        Progress progress;
        int heard = 0;
        const Result<void> watched = watchAxes(
            stylus,
            [&](const AxisReading& reading, double) {
                QTest::qVerify(stylus.isOpen && reading.values[0] == 0.25, "reading", "", __FILE__, __LINE__);
                return ++heard < 5;
            },
            progress);
        QVERIFY(watched.hasValue());
        QCOMPARE(heard, 5);
        QVERIFY(!stylus.isOpen);
        progress.cancel();
        const Result<void> cancelled = watchAxes(
            stylus, [](const AxisReading&, double) { return true; }, progress);
        QCOMPARE(cancelled.error().code, ErrorCode::cancelled);
    }
};

BURIN_TEST(TestAxisMap, NoApplication)

} // namespace burin::tst_axis_map

#include "tst_axis_map.moc"
