// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/driver.h"
#include "plugins/devices/spacemouse/space_mouse.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/comes_true.h"
#include "tests/plugins/scripted_bus.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_spacemouse {

using namespace burin::cap;
using namespace burin::spacemouse;
using test::comesTrue;
using test::ScriptedBus;
using test::Wire;

namespace {

hid::DeviceInfo wireless() {
    hid::DeviceInfo info;
    info.vendor = 0x256f;
    info.product = 0xc62e;
    info.usagePage = 1;
    info.usage = 8;
    return info;
}

struct Fixture {
    explicit Fixture(const std::string& mode = {}) {
        auto made = std::make_unique<ScriptedBus>();
        bus = made.get();
        wire = bus->plug(wireless());
        driver = makeDriver(std::move(made));
        auto any = driver->make("256f:c62e", mode);
        if (any) stylus = std::move(std::get<std::unique_ptr<Stylus>>(*any));
    }
    /// Reads as a loop does, advancing the session by a millisecond without waiting for it.
    StylusState read() { return stylus->read(time += 0.001); }
    bool readings(std::uint64_t count) {
        return comesTrue([this, count] { return stylus->health().readings >= count; });
    }

    ScriptedBus* bus = nullptr;
    std::shared_ptr<Wire> wire;
    std::unique_ptr<DeviceDriver> driver;
    std::unique_ptr<Stylus> stylus;
    double time = 0.0;
};

const Wire::Report pushedRight{0x01, 0x5e, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
const Wire::Report atRest{0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

} // namespace

class TestSpaceMouse : public QObject {
    Q_OBJECT
private slots:
    void itIsFoundWithItsModes() {
        Fixture test;
        hid::DeviceInfo mouse = wireless();
        mouse.product = 0xc650;
        test.bus->plug(mouse);
        const auto found = test.driver->find();
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].name, std::string("SpaceMouse Wireless"));
        QCOMPARE(found[0].modes.size(), std::size_t{2});
        for (const DeviceMode& mode : found[0].modes) QVERIFY(test.driver->make(found[0].id, mode.id));
        QCOMPARE(test.driver->make(found[0].id, "sideways").error().code, ErrorCode::nameUnknown);
        QCOMPARE(test.driver->make("256f:c633", {}).error().code, ErrorCode::deviceNotFound);
        test.bus->forbid();
        QCOMPARE(test.driver->make(found[0].id, {}).error().code, ErrorCode::deviceNotAllowed);
    }

    void itHasNoMotorsAndSaysWhereItsFiguresComeFrom() {
        const Fixture test;
        const StylusDescription description = test.stylus->description();
        QVERIFY(checkDescription(description));
        QVERIFY(!description.hasMotors());
        QCOMPARE(description.sensed.rotations, 3);
        QCOMPARE(description.buttons, 2);
    }

    void theCapSetsTheSpeed() {
        Fixture test;
        QVERIFY(test.stylus->open());
        test.wire->send(pushedRight);
        QVERIFY(test.readings(1));
        test.read();
        for (int i = 0; i < 50; ++i) test.read();
        const StylusState state = test.read();
        QVERIFY(state.valid);
        QVERIFY(std::abs(state.pose.position.x - 0.051 * CapMapping::topSpeed) < 1e-9);
        test.wire->send(atRest);
        QVERIFY(test.readings(2));
        const double stood = test.read().pose.position.x;
        for (int i = 0; i < 50; ++i) QCOMPARE(test.read().pose.position.x, stood);
    }

    void theCapSetsThePlace() {
        Fixture test("position");
        QVERIFY(test.stylus->open());
        test.wire->send(pushedRight);
        QVERIFY(test.readings(1));
        for (int i = 0; i < 90; ++i) test.read();
        QVERIFY(test.read().pose.position.x > 20.0);
    }

    void aReportOfRestThatWasLostDoesNoHarm() {
        Fixture test;
        QVERIFY(test.stylus->open());
        test.wire->send(pushedRight);
        QVERIFY(test.readings(1));
        for (int i = 0; i < 200; ++i) test.read();
        const double stood = test.read().pose.position.x;
        for (int i = 0; i < 100; ++i) QCOMPARE(test.read().pose.position.x, stood);
        QVERIFY(stood <= (SpaceMouse::staleAfter + 0.002) * CapMapping::topSpeed);
        QVERIFY(stood >= (SpaceMouse::staleAfter - 0.002) * CapMapping::topSpeed);
    }

    void buttonsStayDownWithoutFurtherReports() {
        Fixture test;
        QVERIFY(test.stylus->open());
        test.wire->send({0x03, 0x01, 0x00});
        QVERIFY(test.readings(1));
        for (int i = 0; i < 300; ++i) QCOMPARE(test.read().buttons, 1U);
        test.wire->send({0x03, 0x00, 0x00});
        QVERIFY(test.readings(2));
        QCOMPARE(test.read().buttons, 0U);
    }

    void itsLedShinesWhileItIsOpen() {
        Fixture test;
        QVERIFY(test.stylus->open());
        QVERIFY(!test.stylus->open()); // only once
        std::vector<Wire::Report> sent;
        QVERIFY(comesTrue([&] {
            for (const auto& report : test.wire->takeOutputs()) sent.push_back(report);
            return !sent.empty();
        }));
        test.stylus->close();
        for (const auto& report : test.wire->takeOutputs()) sent.push_back(report);
        QCOMPARE(sent, (std::vector<Wire::Report>{{0x04, 0x01}, {0x04, 0x00}}));
    }

    void readingAllocatesNothing() {
        Fixture test;
        QVERIFY(test.stylus->open());
        test.wire->send(pushedRight);
        QVERIFY(test.readings(1));
        const std::size_t before = allocationCount.load();
        for (int i = 0; i < 1000; ++i) {
            test.read();
            test.stylus->write({{1.0, 0.0, 0.0}, {}});
            (void)test.stylus->health();
        }
        QCOMPARE(allocationCount.load(), before);
    }

    void itsBatteryIsTold() {
        Fixture test;
        QVERIFY(!test.stylus->health().batteryShare);
        QVERIFY(test.stylus->open());
        test.wire->send({0x17, 42, 0x01});
        QVERIFY(test.readings(1));
        QVERIFY(std::abs(test.stylus->health().batteryShare.value_or(0.0) - 0.42) < 1e-12);
        QVERIFY(test.stylus->health().charging);
    }

    void unpluggedItSaysSoAndGoesOnWhenItIsBack() {
        Fixture test;
        QVERIFY(test.stylus->open());
        test.wire->send(pushedRight);
        test.wire->send({0x03, 0x01, 0x00});
        QVERIFY(test.readings(2));
        for (int i = 0; i < 20; ++i) test.read();
        test.bus->unplugAll();
        QVERIFY(comesTrue([&] { return !test.read().valid; }));
        const auto fault = test.stylus->takeFault();
        QVERIFY(fault && fault->code == ErrorCode::deviceUnplugged);
        QCOMPARE(fault->subject, std::string("SpaceMouse Wireless"));
        QCOMPARE(test.read().buttons, 0U);
        const double stood = test.read().pose.position.x;
        QCOMPARE(test.read().pose.position.x, stood);
        test.wire = test.bus->plug(wireless());
        QVERIFY(comesTrue([&] { return test.read().valid; }));
        QCOMPARE(test.read().pose.position.x, stood); // at its last position
        test.wire->send(pushedRight);
        QVERIFY(test.readings(3));
        test.read();
        QVERIFY(test.read().pose.position.x > stood);
        QVERIFY(!test.stylus->takeFault());
        QVERIFY(comesTrue([&] { return test.wire->takeOutputs() == (std::vector<Wire::Report>{{0x04, 0x01}}); }));
    }
};

BURIN_TEST(TestSpaceMouse, QCoreApplication)

} // namespace burin::tst_spacemouse

#include "tst_spacemouse.moc"
