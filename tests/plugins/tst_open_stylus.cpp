// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/driver.h"
#include "plugins/devices/open_stylus/open_stylus.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/board_on_bus.h"
#include "tests/plugins/comes_true.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <chrono>
#include <thread>

namespace burin::tst_open_stylus {

using namespace burin::openstylus;
using test::Board;
using test::boardInfo;
using test::comesTrue;
using test::HangingClient;
using test::PluggedBoard;
using test::ScriptedBus;
using test::Wall;
using test::Wire;

namespace {

/// A port that does not allocate: replays what a board sent once, and discards what it is sent.
class PlayedPort final : public hid::Port {
public:
    PlayedPort() {
        std::vector<Board::Report> sent;
        Board source([&sent](const Board::Report& report) {
            sent.push_back(report);
            return true;
        });
        for (std::uint16_t number = 1; number <= reports_.size(); ++number) {
            const auto wrench = encodeOutput({number, 0, number > 1, {}});
            source.receive({wrench.begin(), wrench.end()});
            source.step();
            std::ranges::copy(sent.back(), reports_[number - 1U].begin());
        }
    }
    int read(std::span<std::uint8_t> bytes, int milliseconds) noexcept override {
        if (milliseconds == 0) return 0; // one at a time
        if (next_ == reports_.size()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            return 0;
        }
        std::ranges::copy(reports_[next_++], bytes.begin());
        return static_cast<int>(inputSize);
    }
    bool write(std::span<const std::uint8_t>) noexcept override { return true; }
    int feature(std::span<std::uint8_t>) noexcept override { return -1; }

private:
    std::array<std::array<std::uint8_t, inputSize>, 500> reports_{};
    std::size_t next_ = 0;
};

/// Records the number of the program's allocations at some of its ticks.
class Counter final : public StylusClient {
public:
    Wrench tick(const StylusState& state) noexcept override {
        if (state.valid) ++valid;
        if (valid == 100) early = allocationCount.load();
        if (valid == 400) late = allocationCount.load();
        return {{1.0, 0.0, 0.0}, {}};
    }
    std::atomic<int> valid{0};
    std::atomic<std::size_t> early{0}, late{0};
};

struct Fixture {
    Fixture() : plugged(std::make_unique<PluggedBoard>(bus())), driver(makeDriver(std::move(ownedBus_))) {}
    ScriptedBus& bus() { return *bus_; }
    std::unique_ptr<SelfPacedStylus> make() {
        auto made = driver->make("1209:0001:0001", {});
        if (!made) return nullptr;
        return std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*made));
    }

private:
    std::unique_ptr<ScriptedBus> ownedBus_ = std::make_unique<ScriptedBus>();
    ScriptedBus* bus_ = ownedBus_.get();

public:
    std::unique_ptr<PluggedBoard> plugged;
    std::unique_ptr<DeviceDriver> driver;
};

std::vector<ErrorCode> codesOf(StylusDevice& stylus) {
    std::vector<ErrorCode> codes;
    while (const auto fault = stylus.takeFault()) codes.push_back(fault->code);
    return codes;
}

} // namespace

class TestOpenStylus : public QObject {
    Q_OBJECT
private slots:
    void itIsFoundByWhatItSpeaks() {
        auto bus = std::make_unique<ScriptedBus>();
        bus->plug(boardInfo());
        hid::DeviceInfo mouse = boardInfo();
        mouse.usagePage = 1;
        mouse.usage = 2;
        bus->plug(mouse);
        bus->plug(boardInfo(""));
        bus->plug(boardInfo(""));
        const auto driver = makeDriver(std::move(bus));
        const auto found = driver->find();
        QCOMPARE(found.size(), std::size_t{3});
        QCOMPARE(found[0].id, std::string("1209:0001:0001"));
        QCOMPARE(found[0].name, std::string("Open Stylus mine"));
        QCOMPARE(found[1].id, std::string("1209:0001"));
        QCOMPARE(found[2].id, std::string("1209:0001#2"));
    }

    void itsLimitsComeFromItself() {
        Fixture test;
        const auto stylus = test.make();
        QVERIFY(stylus);
        const StylusDescription description = stylus->description();
        QVERIFY(checkDescription(description));
        QCOMPARE(description.maximumForce.value, 3.0);
        QCOMPARE(description.actuated.rotations, 3);
    }

    void theHandFeelsTheWall() {
        Fixture test;
        Wall wall; // must outlive the stylus, which calls it
        const auto stylus = test.make();
        QVERIFY(stylus->open());
        QVERIFY(stylus->start(wall));
        QVERIFY(!stylus->start(wall)); // only once
        QVERIFY(comesTrue([&] { return wall.valid > 0; }));
        test.plugged->x = -10.0;
        QVERIFY(comesTrue([&] { return test.plugged->force.load() == 1.0; }));
        test.plugged->x = 5.0;
        QVERIFY(comesTrue([&] { return test.plugged->force.load() == 0.0; }));
        QVERIFY(stylus->health().connected);
        QVERIFY(stylus->health().readings > 0);
        stylus->stop();
        QVERIFY(wall.ended && wall.oneThread && wall.timeRises);
        QVERIFY(comesTrue([&] { return !test.plugged->motors.load(); }));
    }

    void unpluggedInMidStrokeItSaysSoAndGoesOnWhenItIsBack() {
        Fixture test;
        Wall wall; // must outlive the stylus, which calls it
        const auto stylus = test.make();
        test.plugged->x = -10.0;
        QVERIFY(stylus->start(wall));
        QVERIFY(comesTrue([&] { return test.plugged->force.load() > 0.0; }));
        codesOf(*stylus);
        test.bus().unplugAll();
        QVERIFY(comesTrue([&] { return !test.plugged->motors.load(); })); // its watchdog
        QVERIFY(comesTrue([&] { return !stylus->health().connected; }));
        QCOMPARE(codesOf(*stylus), std::vector{ErrorCode::deviceUnplugged});
        const int invalid = wall.invalid;
        QVERIFY(comesTrue([&] { return wall.invalid > invalid + 10; })); // the guards go on
        test.plugged = std::make_unique<PluggedBoard>(test.bus());
        test.plugged->x = -20.0;
        QVERIFY(comesTrue([&] { return test.plugged->force.load() == 2.0; }));
        QVERIFY(stylus->health().connected && wall.timeRises);
        stylus->stop();
    }

    void anotherDeviceIsNotTakenForIt() {
        Fixture test;
        Wall wall; // must outlive the stylus, which calls it
        const auto stylus = test.make();
        QVERIFY(stylus->start(wall));
        QVERIFY(comesTrue([&] { return wall.valid > 0; }));
        test.bus().unplugAll();
        open_stylus_limits stronger = Board::limits();
        stronger.maximum_force *= 2;
        PluggedBoard other(test.bus(), stronger); // the same serial number, other limits
        std::this_thread::sleep_for(std::chrono::milliseconds(1200));
        QVERIFY(!stylus->health().connected);
        QVERIFY(!other.motors);
    }

    void aDeviceThatFallsSilentIsAFaultAndComesBack() {
        Fixture test;
        Wall wall; // must outlive the stylus, which calls it
        const auto stylus = test.make();
        QVERIFY(stylus->start(wall));
        QVERIFY(comesTrue([&] { return wall.valid > 0; }));
        codesOf(*stylus);
        const int invalid = wall.invalid;
        test.plugged->silent = true;
        QVERIFY(comesTrue([&] { return wall.invalid > invalid + 60; }));
        QVERIFY(comesTrue([&] { return !codesOf(*stylus).empty(); }));
        QVERIFY(stylus->health().connected);
        const int valid = wall.valid;
        test.plugged->silent = false;
        QVERIFY(comesTrue([&] { return wall.valid > valid + 10; }));
    }

    void itsMotorsGoOffWhenItIsLetGo() {
        Fixture test;
        Wall wall; // must outlive the stylus, which calls it
        auto stylus = test.make();
        QVERIFY(stylus->start(wall));
        QVERIFY(comesTrue([&] { return test.plugged->motors.load(); }));
        const int before = test.plugged->offs;
        stylus.reset();
        QVERIFY(comesTrue([&] { return !test.plugged->motors.load(); }));
        QVERIFY(comesTrue([&] { return test.plugged->offs >= before + 3; }));
    }

    /// The device's own watchdog would take 100 ms; the tick hangs as long as the test determines.
    void itsMotorsCanBeCutWhileATickHangs() {
        HangingClient client; // must outlive the stylus, which calls it
        auto bus = std::make_unique<ScriptedBus>();
        open_stylus_limits limits = Board::limits();
        limits.watchdog = 100;
        PluggedBoard plugged(*bus, limits);
        const auto driver = makeDriver(std::move(bus));
        auto made = driver->make("1209:0001:0001", {});
        QVERIFY(made);
        const auto stylus = std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*made));
        QVERIFY(stylus->start(client));
        QVERIFY(comesTrue([&] { return plugged.force > 0.9; }));
        QVERIFY(client.answers > 0 && client.answers <= client.valid + client.invalid);
        client.hang = true;
        QVERIFY(comesTrue([&] { return client.held.load(); }));
        const int before = client.invalid, offs = plugged.offs;
        stylus->cutMotors();
        QVERIFY(!plugged.motors); // the reports have arrived when the call returns
        QCOMPARE(plugged.force.load(), 0.0);
        QCOMPARE(plugged.offs - offs, 3);
        client.hang = false;
        // It goes on by itself: the motors are off until they have been armed again, which the readings report.
        QVERIFY(comesTrue([&] { return plugged.force > 0.9; }));
        QVERIFY(client.invalid > before);
        QVERIFY(plugged.offs - offs >= 3 + Exchange::armingReports);
        stylus->stop();
        stylus->cutMotors(); // also if nothing runs
        QVERIFY(!plugged.motors);
    }

    void whoMayNotUseItIsTold() {
        Fixture test;
        test.bus().forbid();
        const auto made = test.driver->make("1209:0001:0001", {});
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::deviceNotAllowed);
    }

    void whatIsNoOpenStylusIsRefused_data() {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("a later major version") << 1 << 2 << ErrorCode::deviceIncompatible;
        QTest::newRow("no mark") << 4 << int{'x'} << ErrorCode::deviceFault;
        QTest::newRow("damaged") << 30 << 99 << ErrorCode::deviceStopped;
    }
    void whatIsNoOpenStylusIsRefused() {
        QFETCH(int, at);
        QFETCH(int, value);
        QFETCH(ErrorCode, code);
        Board source([](const Board::Report&) { return true; });
        Board::Report feature = source.feature();
        feature[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
        auto bus = std::make_unique<ScriptedBus>();
        bus->plug(boardInfo(), [feature] { return feature; });
        const auto made = makeDriver(std::move(bus))->make("1209:0001:0001", {});
        QVERIFY(!made);
        QCOMPARE(made.error().code, code);
    }

    void aDeviceWithoutAnAnswerIsRefused() {
        auto bus = std::make_unique<ScriptedBus>();
        bus->plug(boardInfo());
        const auto driver = makeDriver(std::move(bus));
        QCOMPARE(driver->make("1209:0001:0001", {}).error().code, ErrorCode::deviceFault);
        QCOMPARE(driver->make("1209:0001:0002", {}).error().code, ErrorCode::deviceNotFound);
        QCOMPARE(driver->make("1209:0001:0001", "fast").error().code, ErrorCode::nameUnknown);
    }

    void aConnectionAllocatesNothing() {
        ScriptedBus bus;
        Board source([](const Board::Report&) { return true; });
        Identity identity;
        QCOMPARE(decodeFeature(source.feature(), identity), IdentityFault::none);
        OpenStylus stylus(bus, std::make_unique<PlayedPort>(), identity, "played", "played");
        Counter counter;
        QVERIFY(stylus.start(counter));
        QVERIFY(comesTrue([&] { return counter.valid >= 400; }));
        stylus.stop();
        QVERIFY(counter.early > 0U);
        QCOMPARE(counter.late.load(), counter.early.load());
    }
};

BURIN_TEST(TestOpenStylus, QCoreApplication)

} // namespace burin::tst_open_stylus

#include "tst_open_stylus.moc"
