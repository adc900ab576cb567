// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_driver.h"
#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/spacenav/driver.h"
#include "plugins/devices/spacenav/events.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/comes_true.h"
#include "tests/plugins/spacenav_daemon.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>
#include <rapidcheck.h>

#include <cstring>

namespace burin::tst_spacenav {

using burin::spacenav::EventReader;
using burin::test::comesTrue;
using Daemon = burin::test::SpacenavDaemon;
using Packet = Daemon::Packet;

namespace {} // namespace

/// The driver for spacenavd, over a real socket of the kind that the daemon opens.
class TestSpacenav : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString file() const { return folder_.filePath("spnav.sock"); }

private slots:
    void initTestCase() { qputenv("SPNAV_SOCKET", file().toLocal8Bit()); }

    void packetsAreReadInAnyPieces() {
        QVERIFY(rc::check([] {
            const auto packets = *rc::gen::container<std::vector<Packet>>(rc::gen::container<Packet>(
                rc::gen::oneOf(rc::gen::inRange(-3, 40), rc::gen::arbitrary<std::int32_t>())));
            std::vector<std::uint8_t> bytes(packets.size() * EventReader::packetSize);
            if (!packets.empty()) std::memcpy(bytes.data(), packets.data(), bytes.size());
            EventReader whole, pieces;
            std::span<const std::uint8_t> all(bytes), rest(bytes);
            while (!all.empty()) (void)whole.take(all);
            while (!rest.empty()) {
                std::span<const std::uint8_t> piece =
                    rest.first(std::min<std::size_t>(rest.size(), *rc::gen::inRange<std::size_t>(1, 70)));
                rest = rest.subspan(piece.size());
                while (!piece.empty()) (void)pieces.take(piece);
            }
            RC_ASSERT(whole.controls().axes == pieces.controls().axes);
            RC_ASSERT(whole.controls().buttons == pieces.controls().buttons);
            for (const std::int16_t axis : whole.controls().axes) RC_ASSERT(std::abs(axis) <= 700);
        }));
    }

    void axesAndButtonsAreOurs() {
        EventReader reader;
        const auto take = [&](const Packet& packet) {
            std::array<std::uint8_t, EventReader::packetSize> bytes;
            std::memcpy(bytes.data(), packet.data(), bytes.size());
            std::span<const std::uint8_t> rest(bytes);
            return reader.take(rest);
        };
        QVERIFY(take({0, 500, 100, -200, 0, 50, 250, 16}) == EventReader::Kind::motion);
        // x right, y towards the user, z down; 350 counts are the full deflection of a cap.
        QVERIFY(reader.controls().axes == (std::array<std::int16_t, AxisMap::mostAxes>{350, 140, -70, 0, -175, -35}));
        QVERIFY(take({1, 0}) == EventReader::Kind::button && take({1, 3}) == EventReader::Kind::button);
        QCOMPARE(reader.controls().buttons, 9U);
        QVERIFY(take({2, 0}) == EventReader::Kind::button);
        QCOMPARE(reader.controls().buttons, 8U);
        for (const Packet& other : {Packet{1, 32}, Packet{1, -1}, Packet{3, 0}, Packet{-7}})
            QVERIFY(take(other) == EventReader::Kind::none);
        QCOMPARE(reader.controls().buttons, 8U);
        const std::size_t before = allocationCount.load();
        for (int i = 0; i < 100; ++i) (void)take({0, i, i, i, i, i, i, 16});
        QCOMPARE(allocationCount.load(), before);
    }

    void aDaemonThatDoesNotRunIsNoDevice() {
        const auto driver = spacenav::makeDriver();
        QVERIFY(driver->find().empty());
        QCOMPARE(driver->make("daemon", {}).error().code, ErrorCode::deviceNotFound);
        QCOMPARE(driver->make("daemon", "other").error().code, ErrorCode::nameUnknown);
        QFile plain(file()); // an ordinary file with the socket's name
        QVERIFY(plain.open(QIODevice::WriteOnly));
        QVERIFY(driver->find().empty());
        QVERIFY(plain.remove());
    }

    void theCapMovesTheTool() {
        Daemon daemon(file());
        const auto driver = spacenav::makeDriver();
        QCOMPARE(driver->find().size(), std::size_t{1});
        auto made = driver->make("daemon", "rate");
        QVERIFY(made);
        Stylus& stylus = *std::get<std::unique_ptr<Stylus>>(*made);
        QVERIFY(checkDescription(stylus.description()));
        daemon.accept();
        QVERIFY(stylus.open());
        double time = 0.0;
        const auto read = [&] { return stylus.read(time += 0.001); };
        read();
        daemon.send({0, 0, 500, 0, 0, 0, 0, 16}); // up
        daemon.send({1, 1});
        QVERIFY(comesTrue([&] { return stylus.health().readings >= 2; }));
        StylusState state;
        for (int i = 0; i < 200; ++i) state = read();
        QVERIFY(state.valid);
        QVERIFY(std::abs(state.pose.position.z - 20.0) < 0.2); // 100 mm/s for 0.2 s
        QVERIFY(std::abs(state.pose.position.x) < 1e-9 && std::abs(state.pose.position.y) < 1e-9);
        QCOMPARE(state.buttons, 2U);
        const Packet away{0, 0, 0, 500, 0, 0, 0, 16}; // in two pieces
        daemon.send(&away, 13);
        daemon.send(reinterpret_cast<const char*>(&away) + 13, sizeof away - 13);
        QVERIFY(comesTrue([&] { return stylus.health().readings >= 3; }));
        const double before = state.pose.position.y;
        for (int i = 0; i < 100; ++i) state = read();
        QVERIFY(state.pose.position.y > before + 5.0);
    }

    void aDaemonThatEndsIsWaitedFor() {
        Daemon daemon(file());
        const auto driver = spacenav::makeDriver();
        auto made = driver->make("daemon", {});
        QVERIFY(made);
        Stylus& stylus = *std::get<std::unique_ptr<Stylus>>(*made);
        daemon.accept();
        QVERIFY(stylus.open());
        daemon.send({0, 500, 0, 0, 0, 0, 0, 16});
        QVERIFY(comesTrue([&] { return stylus.health().readings >= 1; }));
        daemon.stop();
        QVERIFY(comesTrue([&] { return !stylus.health().connected; }));
        QCOMPARE(stylus.takeFault()->code, ErrorCode::deviceUnplugged);
        QVERIFY(!stylus.read(1.0).valid);
        const glm::dvec3 rest = stylus.read(1.1).pose.position;
        QCOMPARE(stylus.read(1.2).pose.position, rest); // the cap is released
        daemon.listen();
        daemon.accept();
        QVERIFY(comesTrue([&] { return stylus.health().connected; }));
        QVERIFY(stylus.read(2.0).valid);
    }
};

BURIN_TEST(TestSpacenav, QCoreApplication)

} // namespace burin::tst_spacenav

#include "tst_spacenav.moc"
