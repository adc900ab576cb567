// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/input_events/input_devices.h"
#include "plugins/devices/input_events/pad_reader.h"
#include "tests/plugins/virtual_input.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin::tst_gamepad {

using namespace burin::test;
using burin::input_events::hasBit;
using burin::input_events::InputDevice;
using burin::input_events::inputDevices;
using burin::input_events::InputKind;
using burin::input_events::PadReader;

namespace {

/// Two sticks and triggers, as an Xbox pad has them.
auto twoSticks() {
    return virtualInput({{ABS_X, -32768, 32767, 128},
                         {ABS_Y, -32768, 32767, 128},
                         {ABS_RX, -32768, 32767, 128},
                         {ABS_RY, -32768, 32767, 128},
                         {ABS_Z, 0, 255},
                         {ABS_RZ, 0, 255}},
                        {BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_START});
}

MotionShares sharesOf(const PadReader& reader) {
    return motionsOf(reader.map(), cap::readingsOf(reader.controls().axes, PadReader::fullScale));
}

void write(const QString& file, const QByteArray& line) {
    QDir().mkpath(QFileInfo(file).path());
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(line + '\n');
}

/// A pad that nobody touches.
class UntouchedPad final : public cap::ControlSource {
public:
    bool connect() noexcept override { return true; }
    Heard receive(cap::Controls&, int) noexcept override { return Heard::nothing; }
    void disconnect() noexcept override {}
};

/// How far the tool moves along X in 0.1 s without an event, if the calibrated rest is not that which is published.
double driftOf(std::uint32_t silent) {
    cap::CapStylusSettings settings;
    settings.fullScale = PadReader::fullScale;
    settings.silent = silent;
    cap::CapStylus stylus(std::make_unique<UntouchedPad>(), settings);
    AxisMap map = settings.map;
    map.axes[0].rest = 0.3;
    stylus.assign(map);
    stylus.read(0.0);
    return std::abs(stylus.read(0.1).pose.position.x);
}

struct Shown {
    const char *event, *name, *vendor, *product, *serial, *keys, *axes;
};

/// Writes a device's entries in sysfs. The bit fields are those of real devices.
void show(const QString& classes, const Shown& device) {
    const QString folder = classes + '/' + device.event + "/device";
    write(folder + "/name", device.name);
    write(folder + "/uniq", device.serial);
    write(folder + "/id/vendor", device.vendor);
    write(folder + "/id/product", device.product);
    write(folder + "/capabilities/key", device.keys);
    write(folder + "/capabilities/abs", device.axes);
}

} // namespace

/// Gamepads and joysticks: which are found, and the effect of their events.
class TestGamepad : public QObject {
    Q_OBJECT
private slots:
    void bitsAreReadFromTheLastWordOn() {
        QVERIFY(rc::check([] {
            const std::vector<unsigned long> words =
                *rc::gen::nonEmpty(rc::gen::container<std::vector<unsigned long>>(rc::gen::arbitrary<unsigned long>()));
            QStringList text; // lowest word last
            for (const unsigned long word : words) text.prepend(QString::number(word, 16));
            const std::string line = text.join(' ').toStdString();
            const unsigned int bit = *rc::gen::inRange(0U, 64U * static_cast<unsigned int>(words.size()) + 100U);
            const bool set = bit / 64 < words.size() && (words[bit / 64] >> bit % 64 & 1UL) != 0;
            RC_ASSERT(hasBit(line, bit) == set);
        }));
        QVERIFY(!hasBit("", 0) && !hasBit("nonsense", 3));
    }

    void padsAndTabletsAreFoundAndNothingElse() {
        QTemporaryDir folder;
        const QString classes = folder.filePath("class");
        const char* const padKeys = "7cdb000000000000 0 0 0 0";
        show(classes, {"event3", "Pad", "045e", "028e", "", padKeys, "3003f"});
        show(classes, {"event12", "Pad", "045e", "028e", "", padKeys, "3003f"});
        show(classes, {"event4", "Tablet Pen", "056a", "0357", "4K1", "1c0f 0 0 0 0 0", "1000d000003"});
        show(classes, {"event0", "Keyboard", "046d", "c31c", "",
                       "1000000000007 ff9f207ac14057ff febeffdfffefffff fffffffffffffffe", "0"});
        show(classes, {"event1", "Mouse", "046d", "c077", "", "70000 0 0 0 0", "0"});
        show(classes, {"event2", "Touchpad", "06cb", "0001", "", "e520 10000 0 0 0 0", "2e0800000000003"});
        write(classes + "/js0/device/name", "Pad");
        const std::vector<InputDevice> found =
            inputDevices({classes.toStdString(), folder.filePath("nodes").toStdString()});
        QCOMPARE(found.size(), std::size_t{3});
        QCOMPARE(found[0].id, std::string("045e:028e"));
        QCOMPARE(found[0].node.filename().string(), std::string("event3"));
        QCOMPARE(found[0].kind, InputKind::gamepad);
        QCOMPARE(found[1].id, std::string("045e:028e:2"));
        QCOMPARE(found[1].node.filename().string(), std::string("event12"));
        QCOMPARE(found[2].id, std::string("056a:0357:4K1"));
        QCOMPARE(found[2].kind, InputKind::tablet);
        QCOMPARE(found[2].name, std::string("Tablet Pen"));
        QVERIFY(inputDevices({folder.filePath("none").toStdString(), {}}).empty());
    }

    /// With the usual assignment, device frame: y away from the user, z up, rotations right-handed.
    void eachControlMovesTheToolItsWay_data() {
        QTest::addColumn<unsigned int>("code");
        QTest::addColumn<int>("value");
        QTest::addColumn<int>("motion");
        QTest::addColumn<double>("share");
        QTest::newRow("right") << unsigned{ABS_X} << 32767 << 0 << 1.0;
        QTest::newRow("left") << unsigned{ABS_X} << -32768 << 0 << -1.0;
        QTest::newRow("towards the user") << unsigned{ABS_Y} << 32767 << 1 << -1.0;
        QTest::newRow("right stick down") << unsigned{ABS_RY} << 32767 << 2 << -1.0;
        QTest::newRow("right stick right") << unsigned{ABS_RX} << 32767 << 5 << -1.0;
        QTest::newRow("right trigger presses") << unsigned{ABS_RZ} << 255 << 2 << -1.0;
        QTest::newRow("left trigger lifts") << unsigned{ABS_Z} << 255 << 2 << 1.0;
        QTest::newRow("beyond its range") << unsigned{ABS_X} << 100000 << 0 << 1.0;
        QTest::newRow("a stick that does not quite come back") << unsigned{ABS_X} << 3000 << 0 << 0.0;
        QTest::newRow("half") << unsigned{ABS_X} << 16384 << 0 << 0.4 / 0.9;
        QTest::newRow("half a trigger") << unsigned{ABS_Z} << 128 << 2 << (128.0 / 255.0 - 0.1) / 0.9;
    }
    void eachControlMovesTheToolItsWay() {
        QFETCH(unsigned int, code);
        QFETCH(int, value);
        QFETCH(int, motion);
        QFETCH(double, share);
        const auto device = twoSticks();
        PadReader reader(*device);
        for (const double none : sharesOf(reader)) QCOMPARE(none, 0.0); // nothing moved yet
        QCOMPARE(reader.take(eventOf(EV_ABS, code, value)), PadReader::Kind::motion);
        for (std::size_t i = 0; i < motionCount; ++i)
            QVERIFY(std::abs(sharesOf(reader)[i] - (i == static_cast<std::size_t>(motion) ? share : 0.0)) < 1e-4);
    }

    void triggersAndStickAddUp() {
        const auto device = twoSticks();
        PadReader reader(*device);
        reader.take(eventOf(EV_ABS, ABS_RZ, 255));
        reader.take(eventOf(EV_ABS, ABS_Z, 255));
        QCOMPARE(sharesOf(reader)[2], 0.0);
        reader.take(eventOf(EV_ABS, ABS_RY, 32767));
        QCOMPARE(sharesOf(reader)[2], -1.0);
        reader.take(eventOf(EV_ABS, ABS_Z, 0)); // limited to full deflection
        QCOMPARE(sharesOf(reader)[2], -1.0);
    }

    void otherLayouts() {
        const auto older =
            virtualInput({{ABS_X, 0, 255}, {ABS_Y, 0, 255}, {ABS_Z, 0, 255}, {ABS_RZ, 0, 255}}, {BTN_TRIGGER});
        PadReader second(*older); // the second stick is Z and Rz
        second.take(eventOf(EV_ABS, ABS_RZ, 0));
        QCOMPARE(sharesOf(second)[2], 1.0);
        second.take(eventOf(EV_ABS, ABS_X, 128));
        QCOMPARE(sharesOf(second)[0], 0.0);
        const auto joystick =
            virtualInput({{ABS_X, 0, 1023}, {ABS_Y, 0, 1023}, {ABS_RZ, 0, 255}, {ABS_HAT0Y, -1, 1}}, {BTN_TRIGGER});
        PadReader hat(*joystick);
        hat.take(eventOf(EV_ABS, ABS_HAT0Y, -1));
        QCOMPARE(sharesOf(hat)[2], 1.0); // up
        hat.take(eventOf(EV_ABS, ABS_RZ, 255));
        QCOMPARE(sharesOf(hat)[5], -1.0);
        const auto broken = virtualInput({{ABS_X, 5, 5}, {ABS_Y, 9, 1}}, {BTN_TRIGGER}); // empty ranges
        PadReader nothing(*broken);
        QCOMPARE(nothing.take(eventOf(EV_ABS, ABS_X, 5)), PadReader::Kind::none);
        QVERIFY(nothing.axes().empty());
    }

    /// Axes without a use of their own are there to be assigned.
    void everyAxisCanBeAssigned() {
        const auto device =
            virtualInput({{ABS_X, 0, 255}, {ABS_Y, 0, 255}, {ABS_THROTTLE, 0, 255}, {ABS_HAT0X, -1, 1}}, {BTN_TRIGGER});
        PadReader reader(*device);
        QCOMPARE(reader.axes().size(), std::size_t{4});
        const auto throttle = std::ranges::find(reader.axes(), "throttle", &DeviceAxis::name);
        QVERIFY(throttle != reader.axes().end() && !throttle->springs);
        AxisMap map = reader.map();
        AxisUse& use = map.axes[static_cast<std::size_t>(throttle - reader.axes().begin())];
        QCOMPARE(use.motion, AxisMotion::none);
        use.motion = AxisMotion::z;
        use.deadZone = 0.0;
        reader.take(eventOf(EV_ABS, ABS_THROTTLE, 255));
        const auto readings = cap::readingsOf(reader.controls().axes, PadReader::fullScale);
        QCOMPARE(motionsOf(map, readings)[2], 1.0);
        QCOMPARE(motionsOf(reader.map(), readings)[2], 0.0);
    }

    /// A pedal, or a trigger that the kernel names so, moves nothing when it is released.
    void aPedalRestsAtItsLowEnd() {
        const auto device =
            virtualInput({{ABS_X, 0, 255}, {ABS_Y, 0, 255}, {ABS_GAS, 0, 1023}, {ABS_BRAKE, 0, 1023}}, {BTN_TRIGGER});
        PadReader reader(*device);
        AxisMap map = reader.map();
        for (std::size_t i = 2; i < 4; ++i) {
            QVERIFY(reader.axes()[i].oneSided && reader.axes()[i].springs);
            map.axes[i].motion = AxisMotion::z;
        }
        map.axes[3].reversed = true;
        const auto upwards = [&](unsigned int code, int value) {
            reader.take(eventOf(EV_ABS, code, value));
            return motionsOf(map, cap::readingsOf(reader.controls().axes, PadReader::fullScale))[2];
        };
        QCOMPARE(upwards(ABS_GAS, 1023), 1.0);
        QCOMPARE(upwards(ABS_GAS, 0), 0.0);
        QCOMPARE(upwards(ABS_BRAKE, 1023), -1.0);
        QCOMPARE(upwards(ABS_BRAKE, 0), 0.0);
    }

    /// A device may have more axes than can be assigned.
    void noMoreAxesThanCanBeAssigned() {
        const auto device = virtualInput({{ABS_X, 0, 255},
                                          {ABS_Y, 0, 255},
                                          {ABS_Z, 0, 255},
                                          {ABS_RX, 0, 255},
                                          {ABS_RY, 0, 255},
                                          {ABS_RZ, 0, 255},
                                          {ABS_HAT0X, -1, 1},
                                          {ABS_HAT0Y, -1, 1},
                                          {ABS_GAS, 0, 255},
                                          {ABS_BRAKE, 0, 255},
                                          {ABS_THROTTLE, 0, 255},
                                          {ABS_RUDDER, 0, 255},
                                          {ABS_WHEEL, 0, 255}},
                                         {BTN_TRIGGER});
        PadReader reader(*device);
        QCOMPARE(reader.axes().size(), AxisMap::mostAxes);
        QCOMPARE(reader.take(eventOf(EV_ABS, ABS_WHEEL, 255)), PadReader::Kind::none);
    }

    /// Until it moves, an axis counts as at rest wherever the user has calibrated that, so that the tool stays.
    void anAxisThatHasNotMovedIsAtRest() {
        const auto device = twoSticks();
        PadReader reader(*device);
        QCOMPARE(reader.controls().silent, 0x3fU);
        reader.take(eventOf(EV_ABS, ABS_Y, 5));
        QCOMPARE(reader.controls().silent, 0x3dU);
        QCOMPARE(driftOf(1U), 0.0);
        QVERIFY(driftOf(0U) > 0.0);
    }

    void buttonsAreNumberedInTheirOrder() {
        const auto device = twoSticks();
        PadReader reader(*device);
        QCOMPARE(reader.buttonCount(), 5);
        QCOMPARE(reader.take(eventOf(EV_KEY, BTN_EAST, 1)), PadReader::Kind::button);
        reader.take(eventOf(EV_KEY, BTN_SOUTH, 1));
        QCOMPARE(reader.controls().buttons, 3U);
        reader.take(eventOf(EV_KEY, BTN_SOUTH, 0));
        QCOMPARE(reader.controls().buttons, 2U);
        QCOMPARE(reader.take(eventOf(EV_KEY, KEY_A, 1)), PadReader::Kind::none);
    }

    void noEventLeavesTheRange() {
        QVERIFY(rc::check([] {
            const auto device = twoSticks();
            PadReader reader(*device);
            for (int i = 0; i < 50; ++i) {
                reader.take(
                    eventOf(*rc::gen::inRange(0U, 32U), *rc::gen::inRange(0U, 0x300U), *rc::gen::arbitrary<int>()));
                for (const std::int16_t count : reader.controls().axes)
                    RC_ASSERT(std::abs(count) <= PadReader::fullScale);
                RC_ASSERT(reader.controls().buttons < 32U);
            }
        }));
    }
};

BURIN_TEST(TestGamepad, NoApplication)

} // namespace burin::tst_gamepad

#include "tst_gamepad.moc"
