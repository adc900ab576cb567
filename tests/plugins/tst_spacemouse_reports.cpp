// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/deflection.h"
#include "plugins/devices/cap/cap_mapping.h"
#include "plugins/devices/spacemouse/models.h"
#include "plugins/devices/spacemouse/reports.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cmath>

namespace burin::tst_spacemouse_reports {

using namespace burin::cap;
using namespace burin::spacemouse;

namespace {

std::vector<std::uint8_t> bytes(const QString& hex) {
    const QByteArray raw = QByteArray::fromHex(hex.toLatin1());
    return {raw.begin(), raw.end()};
}

/// The numbers of the pressed buttons, from 1.
QString pressed(std::uint32_t buttons) {
    QStringList numbers;
    for (int i = 0; i < 32; ++i)
        if ((buttons >> i & 1U) != 0) numbers.append(QString::number(i + 1));
    return numbers.join(QLatin1Char(' '));
}

using Counts = std::array<std::int16_t, AxisMap::mostAxes>;

/// The motions of a cap with the usual assignment.
MotionShares pushedBy(const Counts& counts) {
    return motionsOf(capMap(), readingsOf(counts, CapMapping::fullScale));
}

QString axesOf(const Controls& controls) {
    QStringList numbers;
    for (std::size_t i = 0; i < 6; ++i) numbers.append(QString::number(controls.axes[i]));
    return numbers.join(QLatin1Char(' '));
}

Pose after(ControlMode mode, const Counts& axes, int milliseconds) {
    CapMapping mapping(mode);
    Pose pose;
    for (int i = 0; i < milliseconds; ++i) pose = mapping.advance(pushedBy(axes), 0.001);
    return pose;
}

} // namespace

class TestSpaceMouseReports : public QObject {
    Q_OBJECT
private slots:
    /// Reports as recorded from devices (SpaceNavigator: AndunHH/spacemouse; Compact: CloudCompare pull request 2339),
    /// and as laid out by their descriptors.
    void eachLayoutIsRead_data() {
        QTest::addColumn<QStringList>("reports");
        QTest::addColumn<QString>("axes");
        QTest::addColumn<QString>("buttons");
        const auto row = [](const char* name, const QStringList& reports, const char* axes, const char* buttons) {
            QTest::newRow(name) << reports << QString::fromLatin1(axes) << QString::fromLatin1(buttons);
        };
        row("nothing yet", {}, "0 0 0 0 0 0", "");
        row("Navigator at rest", {"01000000000000"}, "0 0 0 0 0 0", "");
        row("Navigator turned", {"01000000000000", "020000e2ff0000"}, "0 0 0 0 -30 0", "");
        row("Navigator's left button", {"030100"}, "0 0 0 0 0 0", "1");
        row("Navigator's right button", {"030200"}, "0 0 0 0 0 0", "2");
        row("Navigator's both buttons", {"030300"}, "0 0 0 0 0 0", "1 2");
        row("a button let go", {"030300", "030000"}, "0 0 0 0 0 0", "");
        row("Compact", {"01120000001201", "02200000001700"}, "18 0 274 32 0 23", "");
        row("Wireless, all axes in one", {"01010002000300fffffeff9cff"}, "1 2 3 -1 -2 -100", "");
        row("full scale both ways", {"015e01a2fe5e01a2fe5e01a2fe"}, "350 -350 350 -350 350 -350", "");
        row("Pro, sparse buttons", {"0321100004"}, "0 0 0 0 0 0", "1 6 13 27");
        row("Enterprise, button 31", {"0300000040"}, "0 0 0 0 0 0", "31");
        row("Enterprise, pressed buttons by number",
            {"1c0d00240000000000000000"
             "00"},
            "0 0 0 0 0 0", "13");
        row("Enterprise, both ways at once",
            {"0301000000", "1c0d000000000000000000"
                           "0000"},
            "0 0 0 0 0 0", "1 13");
        row("Enterprise, let go",
            {"1c0d000000000000000000"
             "0000",
             "1c00000000000000000000"
             "0000"},
            "0 0 0 0 0 0", "");
        row("filled up to the longest",
            {"0301000000000000000000"
             "0000"},
            "0 0 0 0 0 0", "1");
        row("too short to be one", {"01", "0102", "010203040506", "0200000000", "03", "1c00", "17", "1705"},
            "0 0 0 0 0 0", "");
        row("empty", {""}, "0 0 0 0 0 0", "");
        row("settings and what else there is", {"05ff", "0affffffffffffff", "1dff00ff00ff00ff00ff00ff00", "ffff"},
            "0 0 0 0 0 0", "");
        row("three axes keep the other three", {"01010002000300fffffeff9cff", "01050006000700"}, "5 6 7 -1 -2 -100",
            "");
    }
    void eachLayoutIsRead() {
        QFETCH(QStringList, reports);
        QFETCH(QString, axes);
        QFETCH(QString, buttons);
        ReportReader reader;
        for (const QString& report : reports) reader.take(bytes(report));
        QCOMPARE(axesOf(reader.controls()), axes);
        QCOMPARE(pressed(reader.controls().buttons), buttons);
    }

    void keysBeyondThirtyTwoAreKept() {
        ReportReader reader;
        QCOMPARE(reader.take(bytes("1c2400670d000000000000"
                                   "0000")),
                 ReportKind::buttons); // 36, 3431, …
        QCOMPARE(reader.controls().keys[0], std::uint8_t{36});
        QCOMPARE(reader.controls().keys[1], std::uint8_t{0}); // no such usage
        reader.take(bytes("1c67002400000000000000"
                          "0000"));
        QCOMPARE(reader.controls().keys[0], std::uint8_t{103});
        QCOMPARE(reader.controls().keys[1], std::uint8_t{36});
    }

    void theBatteryIsRead() {
        ReportReader reader;
        QCOMPARE(reader.controls().batteryPercent, std::int8_t{-1});
        QCOMPARE(reader.take(bytes("176401")), ReportKind::battery); // recorded from a Wireless
        QCOMPARE(reader.controls().batteryPercent, std::int8_t{100});
        QVERIFY(reader.controls().charging);
        QCOMPARE(reader.take(bytes("170c00")), ReportKind::battery);
        QCOMPARE(reader.controls().batteryPercent, std::int8_t{12});
        QVERIFY(!reader.controls().charging);
        QCOMPARE(reader.take(bytes("17ff00")), ReportKind::unknown); // not a percentage
        reader.rest();
        QCOMPARE(reader.controls().batteryPercent, std::int8_t{12});
    }

    void theLedIsSwitched() {
        QCOMPARE(ledReport(true), (std::array<std::uint8_t, 2>{0x04, 0x01}));
        QCOMPARE(ledReport(false), (std::array<std::uint8_t, 2>{0x04, 0x00}));
    }

    void anyBytesDoNoHarm() {
        QVERIFY(rc::check("whatever the bus brings", [] {
            ReportReader reader;
            const auto reports = *rc::gen::container<std::vector<std::vector<std::uint8_t>>>(
                rc::gen::arbitrary<std::vector<std::uint8_t>>());
            for (const auto& report : reports) reader.take(report);
            RC_ASSERT(reader.controls().batteryPercent >= -1 && reader.controls().batteryPercent <= 100);
            reader.rest();
            RC_ASSERT(reader.controls().buttons == 0U);
        }));
    }

    void miceAndKeyboardsOfTheVendorAreLeftAlone() {
        QVERIFY(isSpaceMouse(0x256f, 0xc635, 1, 8));
        QVERIFY(isSpaceMouse(0x046d, 0xc626, 1, 8));
        QVERIFY(isSpaceMouse(0x256f, 0xc6ff, 1, 8));  // a future model
        QVERIFY(!isSpaceMouse(0x256f, 0xc650, 1, 8)); // CadMouse
        QVERIFY(!isSpaceMouse(0x256f, 0xc668, 1, 8)); // keyboard
        QVERIFY(!isSpaceMouse(0x256f, 0xc652, 1, 2)); // the receiver's mouse
        QVERIFY(!isSpaceMouse(0x046d, 0xc077, 1, 2)); // a mouse
        QVERIFY(!isSpaceMouse(0x1234, 0xc635, 1, 8));
        QVERIFY(isSpaceMouse(0x256f, 0xc635, 0, 0));
        QVERIFY(!isSpaceMouse(0x256f, 0xc6ff, 0, 0));
        QCOMPARE(QString::fromLatin1(modelOf(0x256f, 0xc633)->name), QStringLiteral("SpaceMouse Enterprise"));
        QVERIFY(modelOf(0x256f, 0xc6ff) == nullptr);
    }

    void theResponseIsOddRisingAndEndsAtOne() {
        // Of the first axis: dead zone, then the curve.
        const auto response = [](int counts) {
            return deflectionCurve(shareOf(capMap().axes[0], counts / CapMapping::fullScale));
        };
        QCOMPARE(response(0), 0.0);
        QCOMPARE(response(17), 0.0); // 4.9 %
        QCOMPARE(response(350), 1.0);
        QCOMPARE(response(-350), -1.0);
        QCOMPARE(response(500), 1.0); // some devices exceed the range
        QCOMPARE(response(-32768), -1.0);
        for (int counts = 0; counts < 350; ++counts) {
            const double here = response(counts), next = response(counts + 1);
            QVERIFY(next >= here && next - here < 0.01); // no jump: less than 1 % of the range per count
            QCOMPARE(response(-counts), -here);
        }
    }

    /// Frames: cap x right, y towards the user, z down; device x right, y away, z up.
    void theCapLeadsWhereItIsPushed_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("moves"); // axis of the device for the translation or rotation
        QTest::addColumn<double>("sign");
        QTest::newRow("right") << 0 << 0 << 1.0;
        QTest::newRow("towards the user") << 1 << 1 << -1.0;
        QTest::newRow("down") << 2 << 2 << -1.0;
        QTest::newRow("about x") << 3 << 0 << 1.0;
        QTest::newRow("about y") << 4 << 1 << -1.0;
        QTest::newRow("about z") << 5 << 2 << -1.0;
    }
    void theCapLeadsWhereItIsPushed() {
        QFETCH(int, axis);
        QFETCH(int, moves);
        QFETCH(double, sign);
        Counts axes{};
        axes[static_cast<std::size_t>(axis)] = 350;
        const Pose rate = after(ControlMode::rate, axes, 200);
        const Pose position = after(ControlMode::position, axes, 2000);
        glm::dvec3 expected(0.0);
        expected[moves] = sign;
        if (axis < 3) {
            QVERIFY(glm::length(rate.position - 0.2 * CapMapping::topSpeed * expected) < 1e-9);
            QVERIFY(glm::length(position.position - CapMapping::reach * expected) < 1e-3);
            QVERIFY(std::abs(rate.rotation.w - 1.0) < 1e-12 && std::abs(position.rotation.w - 1.0) < 1e-12);
        } else {
            QVERIFY(std::abs(glm::angle(rate.rotation) - 0.2 * CapMapping::topTurn) < 1e-9);
            QVERIFY(glm::length(glm::axis(rate.rotation) - expected) < 1e-9);
            QVERIFY(std::abs(glm::angle(position.rotation) - CapMapping::turnReach) < 1e-3);
            QVERIFY(glm::length(glm::axis(position.rotation) - expected) < 1e-9);
            QVERIFY(glm::length(rate.position) == 0.0);
        }
    }

    void letGoRateStandsAndPositionReturns() {
        const Counts pushed{350, 0, 0, 0, 350, 0}, rest{};
        CapMapping rate(ControlMode::rate), position(ControlMode::position);
        for (int i = 0; i < 500; ++i) {
            rate.advance(pushedBy(pushed), 0.001);
            position.advance(pushedBy(pushed), 0.001);
        }
        const Pose stood = rate.advance(pushedBy(rest), 0.001);
        for (int i = 0; i < 2000; ++i) {
            rate.advance(pushedBy(rest), 0.001);
            position.advance(pushedBy(rest), 0.001);
        }
        QCOMPARE(rate.advance(pushedBy(rest), 0.001).position, stood.position);
        QVERIFY(stood.position.x > 40.0);
        QVERIFY(glm::length(position.advance(pushedBy(rest), 0.001).position) < 1e-9);
        QVERIFY(std::abs(position.advance(pushedBy(rest), 0.001).rotation.w - 1.0) < 1e-12);
    }

    void noHandIsFasterThanStatedAndNoneLeavesTheWorkspace() {
        QVERIFY(rc::check("any axes, any pauses", [] {
            const bool rates = *rc::gen::arbitrary<bool>();
            CapMapping mapping(rates ? ControlMode::rate : ControlMode::position);
            Pose before;
            for (int i = 0; i < 400; ++i) {
                Counts axes{};
                for (auto& axis : axes) axis = *rc::gen::arbitrary<std::int16_t>();
                const double seconds = *rc::gen::inRange(0, 200) * 1e-4;
                const Pose pose = mapping.advance(pushedBy(axes), seconds);
                RC_ASSERT(glm::length(pose.position) <= CapMapping::workspaceRadius + 1e-9);
                RC_ASSERT(glm::length(pose.position - before.position) <= CapMapping::followSpeed * seconds + 1e-9);
                RC_ASSERT(std::abs(glm::length(pose.rotation) - 1.0) < 1e-9);
                before = pose;
            }
        }));
    }

    void aTickAllocatesNothing() {
        ReportReader reader;
        CapMapping mapping(ControlMode::rate);
        const std::vector<std::uint8_t> report = bytes("01010002000300fffffeff9cff");
        const std::size_t before = allocationCount.load();
        for (int i = 0; i < 1000; ++i) {
            reader.take(report);
            mapping.advance(pushedBy(reader.controls().axes), 0.001);
        }
        QCOMPARE(allocationCount.load(), before);
    }
};

BURIN_TEST(TestSpaceMouseReports, NoApplication)

} // namespace burin::tst_spacemouse_reports

#include "tst_spacemouse_reports.moc"
