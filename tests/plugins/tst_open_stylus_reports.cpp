// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/reports.h"
#include "tests/places.h"
#include "tests/plugins/board.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QtTest>
#include <rapidcheck.h>

#include <cmath>
#include <random>

namespace burin::tst_open_stylus_reports {

using namespace burin::openstylus;
using test::Board;

namespace {

/// The blocks of bytes in protocol.md, in their order: descriptor, reading, wrench, identity.
QList<QByteArray> documentedBytes() {
    QFile file(QStringLiteral(BURIN_SOURCE_DIRECTORY "/plugins/devices/open_stylus/protocol.md"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QList<QByteArray> blocks;
    const QStringList parts = QString::fromUtf8(file.readAll()).split(QStringLiteral("```"));
    static const QRegularExpression comment(QStringLiteral("   .*")), space(QStringLiteral("\\s+"));
    for (qsizetype i = 1; i < parts.size(); i += 2) {
        QByteArray bytes;
        for (QString line : parts[i].split(QLatin1Char('\n')))
            bytes += QByteArray::fromHex(line.remove(comment).remove(space).toLatin1());
        blocks.append(bytes);
    }
    return blocks;
}

std::vector<std::uint8_t> vectorOf(const QByteArray& bytes) {
    return {bytes.begin(), bytes.end()};
}

Identity identityOf(const Board& board) {
    Identity identity;
    if (decodeFeature(board.feature(), identity) != IdentityFault::none) std::abort(); // error in the test's own set-up
    return identity;
}

double anyLength() {
    return static_cast<double>(*rc::gen::inRange(-2000000000, 2000000000)) / 65536.0;
}

} // namespace

class TestOpenStylusReports : public QObject {
    Q_OBJECT
private slots:
    void theCheckSumIsTheCatalogues() {
        const std::string text = "123456789"; // check value of CRC-16/IBM-3740 in the RevEng catalogue
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        QCOMPARE(checksumOf(bytes), std::uint16_t{0x29b1});
        QCOMPARE(open_stylus_crc(bytes.data(), bytes.size()), std::uint16_t{0x29b1});
    }

    void theDescriptorIsTheDocumentedOne() {
        const auto documented = vectorOf(documentedBytes().value(0));
        QCOMPARE(documented, std::vector<std::uint8_t>(open_stylus_descriptor,
                                                       open_stylus_descriptor + OPEN_STYLUS_DESCRIPTOR_SIZE));
    }

    void aReadingIsReadAsDocumented() {
        const auto bytes = vectorOf(documentedBytes().value(1));
        const auto reading = decodeInput(bytes);
        QVERIFY(reading);
        QCOMPARE(reading->sequence, std::uint16_t{65534});
        QCOMPARE(reading->microseconds, 2309737967U);
        QCOMPARE(reading->pose.position, glm::dvec3(12.5, -0.25, 100.0 + 0x1.0p-16));
        QCOMPARE(reading->pose.rotation, glm::dquat(0.5, -0.5, 0.5, 0.5));
        QCOMPARE(reading->buttons, 0x80000005U);
        QCOMPARE(reading->faults, std::uint16_t{reportedWatchdog | reportedMechanism});
        QCOMPARE(reading->echo, std::uint16_t{4660});
        QCOMPARE(reading->motorHeat, std::optional<double>(0.5));
        QVERIFY(reading->motorsOn && reading->poseValid && reading->heard && !reading->saturated);
    }

    void aWrenchIsWrittenAsDocumented() {
        Command command;
        command.sequence = 258;
        command.echo = 65534;
        command.motors = true;
        command.wrench = {{1.5, -2.25, 0x1.0p-16}, {-100.0, 0.5, 0.0}};
        const auto report = encodeOutput(command);
        QCOMPARE(std::vector<std::uint8_t>(report.begin(), report.end()), vectorOf(documentedBytes().value(2)));
    }

    void anIdentityIsReadAsDocumented() {
        Identity identity;
        QCOMPARE(decodeFeature(vectorOf(documentedBytes().value(3)), identity), IdentityFault::none);
        QCOMPARE(identity.firmware, (std::array<int, 3>{1, 2, 772}));
        QVERIFY(identity.sensed == (Freedoms{3, 3}) && identity.actuated == (Freedoms{3, 3}));
        QCOMPARE(identity.buttons, 2);
        QCOMPARE(identity.source, 2);
        QCOMPARE(identity.rate, 1000.0);
        QCOMPARE(identity.watchdog, 0.02);
        QCOMPARE(identity.delay, 250e-6);
        QCOMPARE(identity.maximumSpeed, 1000.0);
        QCOMPARE(identity.maximumForce, 3.25);
        QCOMPARE(identity.continuousForce, 1.5);
        QCOMPARE(identity.maximumTorque, 90.5);
        QCOMPARE(identity.maximumStiffness, 450.25);
        QCOMPARE(identity.maximumDamping, 4.5);
        QCOMPARE(identity.maximumTurningStiffness, 300.0);
        QCOMPARE(identity.workspaceRadius, 80.0);
        QCOMPARE(identity.positionStep, 335544 * 0x1.0p-24);
        QCOMPARE(identity.rotationStep, 536870 * 0x1.0p-30);
        QCOMPARE(int{identity.minor}, 1);
        QCOMPARE(identity.handleMass, 0.0625);
    }

    /// Bytes 60 and 61 were reserved in 1.0: whatever they contain, no gravity compensation results from them.
    void anOlderFirmwareStatesNoMass() {
        auto bytes = vectorOf(documentedBytes().value(3));
        bytes[2] = 0;
        const std::uint16_t crc = open_stylus_crc(bytes.data(), 62);
        bytes[62] = static_cast<std::uint8_t>(crc & 0xffU);
        bytes[63] = static_cast<std::uint8_t>(crc >> 8U);
        Identity identity;
        QCOMPARE(decodeFeature(bytes, identity), IdentityFault::none);
        QCOMPARE(identity.handleMass, 0.0);
        QCOMPARE(identity.rotationStep, 536870 * 0x1.0p-30); // everything else as usual
        QVERIFY(checkDescription(descriptionOf(identity, "old")));
    }

    void whatTheFirmwareMeasuresArrivesExactly() {
        QVERIFY(rc::check("every field of a reading", [] {
            std::vector<Board::Report> sent;
            Board board([&sent](const Board::Report& report) {
                sent.push_back(report);
                return true;
            });
            for (auto& step : board.reading.position) step = *rc::gen::arbitrary<std::int32_t>();
            board.reading.buttons = *rc::gen::arbitrary<std::uint32_t>();
            board.reading.heat = *rc::gen::arbitrary<std::uint8_t>();
            board.microseconds = *rc::gen::arbitrary<std::uint32_t>();
            const double angle = *rc::gen::inRange(-3141, 3141) * 1e-3;
            board.reading.rotation[0] = static_cast<std::int32_t>(std::cos(angle) * 0x1.0p30);
            board.reading.rotation[2] = static_cast<std::int32_t>(std::sin(angle) * 0x1.0p30);
            board.step(0);
            RC_ASSERT(sent.size() == 1U);
            const auto reading = decodeInput(sent[0]);
            RC_ASSERT(reading.has_value());
            for (int i = 0; i < 3; ++i) RC_ASSERT(reading->pose.position[i] * 65536.0 == board.reading.position[i]);
            RC_ASSERT(reading->pose.rotation.w * 0x1.0p30 == board.reading.rotation[0]);
            RC_ASSERT(reading->pose.rotation.y * 0x1.0p30 == board.reading.rotation[2]);
            RC_ASSERT(reading->buttons == board.reading.buttons);
            RC_ASSERT(reading->microseconds == board.microseconds);
            RC_ASSERT(reading->motorHeat.has_value() == (board.reading.heat != 255));
            if (reading->motorHeat) RC_ASSERT(std::lround(*reading->motorHeat * 200.0) == board.reading.heat);
        }));
    }

    void theFirmwareRendersWhatIsSent() {
        QVERIFY(rc::check("the wrench to half a step, shortened to the limits", [] {
            open_stylus_limits limits = Board::limits();
            limits.maximum_force = limits.maximum_torque = 0x7fffffffU;
            Board board([](const Board::Report&) { return true; }, limits);
            Command command;
            command.sequence = 1;
            const auto off = encodeOutput(command);
            RC_ASSERT(board.receive({off.begin(), off.end()}));
            command.sequence = 2;
            command.motors = true;
            for (int i = 0; i < 3; ++i) {
                command.wrench.force[i] = 0.5 * anyLength();
                command.wrench.torque[i] = 0.5 * anyLength();
            }
            const auto on = encodeOutput(command);
            RC_ASSERT(board.receive({on.begin(), on.end()}));
            RC_ASSERT(board.motorsOn);
            for (int i = 0; i < 3; ++i) {
                const auto at = static_cast<std::size_t>(i);
                RC_ASSERT(std::abs(board.force[at] - command.wrench.force[i] * 65536.0) <= 0.5);
                RC_ASSERT(std::abs(board.torque[at] - command.wrench.torque[i] * 65536.0) <= 0.5);
            }
        }));
    }

    void whatIsNotFiniteIsSentAsZero() {
        Command command;
        command.wrench.force = {std::nan(""), HUGE_VAL, -HUGE_VAL};
        command.wrench.torque = {1e300, -1e300, 0.0};
        const auto report = encodeOutput(command);
        for (std::size_t i = 4; i < 16; ++i) QCOMPARE(report[i], std::uint8_t{0});
        QCOMPARE(report[19], std::uint8_t{0x7f}); // + 32767
        QCOMPARE(report[23], std::uint8_t{0x80}); // - 32767
    }

    /// CRC-16 detects every burst of up to 16 bits: each damaged byte, each pair of neighbouring bytes.
    void everyDamageIsFound() {
        const auto reading = vectorOf(documentedBytes().value(1));
        const auto identity = vectorOf(documentedBytes().value(3));
        std::mt19937 random(3);
        Identity into;
        int tried = 0;
        const auto damage = [&](const std::vector<std::uint8_t>& good, auto refuses) {
            for (std::size_t at = 0; at < good.size(); ++at)
                for (unsigned change = 1; change < 256; ++change) {
                    auto bad = good;
                    bad[at] = static_cast<std::uint8_t>(bad[at] ^ change);
                    if (at + 1 < bad.size()) bad[at + 1] = static_cast<std::uint8_t>(bad[at + 1] ^ (random() & 0xffU));
                    QVERIFY2(refuses(bad), qPrintable(QStringLiteral("byte %1 ^ %2").arg(at).arg(change)));
                    ++tried;
                }
        };
        damage(reading, [](const auto& bad) { return !decodeInput(bad); });
        damage(identity, [&](const auto& bad) { return decodeFeature(bad, into) != IdentityFault::none; });
        QCOMPARE(tried, 255 * (48 + 64));
    }

    void everyOtherSizeIsRefused() {
        const auto reading = vectorOf(documentedBytes().value(1)), identity = vectorOf(documentedBytes().value(3));
        Identity into;
        for (std::size_t size = 0; size <= 80; ++size) {
            auto report = reading;
            report.resize(size);
            QCOMPARE(decodeInput(report).has_value(), size == inputSize);
            report = identity;
            report.resize(size);
            QCOMPARE(decodeFeature(report, into) == IdentityFault::none, size == featureSize);
        }
    }

    void theFirmwareTakesNoDamagedWrench() {
        const auto good = encodeOutput({1, 0, false, {{1.0, 2.0, 3.0}, {}}});
        for (std::size_t at = 0; at < good.size(); ++at)
            for (unsigned change = 1; change < 256; ++change) {
                Board board([](const Board::Report&) { return true; });
                Board::Report bad(good.begin(), good.end());
                bad[at] = static_cast<std::uint8_t>(bad[at] ^ change);
                QVERIFY(!board.receive(bad));
            }
        for (std::size_t size = 0; size <= 64; ++size) {
            Board board([](const Board::Report&) { return true; });
            Board::Report other(good.begin(), good.end());
            other.resize(size);
            QCOMPARE(board.receive(other), size == outputSize);
        }
    }

    void aRotationThatIsNoneIsRefused_data() {
        QTest::addColumn<int>("share"); // of a unit quaternion's length, in thousandths
        QTest::addColumn<bool>("taken");
        QTest::newRow("unit") << 1000 << true;
        QTest::newRow("1 % long") << 1009 << true;
        QTest::newRow("short") << 980 << false;
        QTest::newRow("long") << 1020 << false;
        QTest::newRow("zero") << 0 << false;
    }
    void aRotationThatIsNoneIsRefused() {
        QFETCH(int, share);
        QFETCH(bool, taken);
        std::vector<Board::Report> sent;
        Board board([&sent](const Board::Report& report) {
            sent.push_back(report);
            return true;
        });
        board.reading.rotation[0] = static_cast<std::int32_t>(share * 1e-3 * 0x1.0p30);
        board.step();
        QCOMPARE(decodeInput(sent.at(0)).has_value(), taken);
    }

    void identitiesOutOfRangeAreRefused_data() {
        QTest::addColumn<int>("row");
        const char* rows[] = {
            "four rotations", "33 buttons",           "a fifth source",           "99 Hz",
            "8001 Hz",        "watchdog of 1 ms",     "watchdog of 101 ms",       "no workspace",
            "no speed",       "motors without force", "motors without stiffness", "turning motors without torque"};
        for (int i = 0; i < static_cast<int>(std::size(rows)); ++i) QTest::newRow(rows[i]) << i;
    }
    void identitiesOutOfRangeAreRefused() {
        QFETCH(int, row);
        open_stylus_limits limits = Board::limits();
        switch (row) {
        case 0:
            limits.sensed_rotations = 4;
            break;
        case 1:
            limits.buttons = 33;
            break;
        case 2:
            limits.source = 4;
            break;
        case 3:
            limits.rate = 99;
            break;
        case 4:
            limits.rate = 8001;
            break;
        case 5:
            limits.watchdog = 1;
            break;
        case 6:
            limits.watchdog = 101;
            break;
        case 7:
            limits.workspace_radius = 0;
            break;
        case 8:
            limits.maximum_speed = 0;
            break;
        case 9:
            limits.maximum_force = 0;
            break;
        case 10:
            limits.maximum_stiffness = 0;
            break;
        default:
            limits.maximum_torque = 0;
            break;
        }
        Board board([](const Board::Report&) { return true; }, limits);
        Identity identity;
        QCOMPARE(decodeFeature(board.feature(), identity), IdentityFault::outOfRange);
    }

    void anotherMajorVersionIsToldApart() {
        Board board([](const Board::Report&) { return true; });
        Board::Report report = board.feature();
        report[1] = 2; // whatever its checksum covers
        Identity identity;
        QCOMPARE(decodeFeature(report, identity), IdentityFault::otherVersion);
        QCOMPARE(int{identity.major}, 2);
        report[4] = 'X';
        QCOMPARE(decodeFeature(report, identity), IdentityFault::foreign);
    }

    void aDescriptionStatesWhoseFiguresTheyAre() {
        Board board([](const Board::Report&) { return true; });
        const StylusDescription description = descriptionOf(identityOf(board), "mine");
        QVERIFY(checkDescription(description));
        QCOMPARE(description.name, std::string("mine"));
        QCOMPARE(description.maximumForce.value, 3.0);
        QVERIFY(description.maximumForce.source.find("measured on its design") != std::string::npos);
        QCOMPARE(description.maximumStiffness.value, 400.0);
        QCOMPARE(description.handleMass.value, 0.03125); // kg
        QVERIFY(!description.carriesHandle && !description.handleMass.source.empty());
        QVERIFY(description.hasMotors());
    }
};

BURIN_TEST(TestOpenStylusReports, QCoreApplication)

} // namespace burin::tst_open_stylus_reports

#include "tst_open_stylus_reports.moc"
