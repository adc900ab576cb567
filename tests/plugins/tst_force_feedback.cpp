// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/assisted_stylus.h"
#include "plugins/devices/input_events/pad_reader.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/comes_true.h"
#include "tests/plugins/effect_device.h"
#include "tests/plugins/virtual_input.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>

namespace burin::tst_force_feedback {

using namespace burin::test;
using namespace burin::input_events;

namespace {

constexpr AssistAbilities stick{.rumble = false, .forceAxes = 2}, pad{.rumble = true, .forceAxes = 0};
constexpr ForceAbilities everything{
    .rumble = true, .constant = true, .spring = true, .damper = true, .gain = true, .autocentre = true, .axes = 2};
constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

/// The usual assignment of a stick: its first axis moves to the right, its second one towards the user.
AxisMap usualMap() {
    const auto device = virtualInput({{ABS_X, 0, 255}, {ABS_Y, 0, 255}}, {BTN_TRIGGER});
    return PadReader(*device).map();
}

Assist pushing(const glm::dvec3& force, double ceiling = 1.0) {
    Assist assist;
    assist.force = force;
    assist.ceiling = ceiling;
    return assist;
}

EffectLevels pushed(double share, double ceiling = 1.0) {
    return encoded(pushing({share, 0.0, 0.0}, ceiling), usualMap(), stick);
}

/// What a device with these values pushes, x to the right, y away: the kernel's angles count clockwise from the user.
glm::dvec2 decoded(std::uint16_t direction, int level) {
    const double angle = 2.0 * std::numbers::pi * direction / 65536.0, size = level / 32767.0;
    return {-size * std::sin(angle), -size * std::cos(angle)};
}

/// A stylus that nobody moves.
class StillStylus final : public Stylus {
public:
    StylusDescription description() const override {
        StylusDescription description;
        description.name = "still";
        description.buttons = 2;
        description.workspaceRadius = {60.0, "made up"};
        return description;
    }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    StylusState read(double time) noexcept override {
        StylusState state;
        state.time = time;
        state.valid = true;
        return state;
    }
    void write(const Wrench&) noexcept override {}
    AxisMap axisMap() const override { return usualMap(); }
};

/// Steps a writer as its thread does, and posts levels as a loop does.
struct Written {
    explicit Written(const ForceAbilities& abilities = everything)
        : writer(device.opener(), abilities, "stick", "/dev/input/event7") {}
    /// @param posts whether the loop runs
    void run(double seconds, const EffectLevels& levels, bool posts = true) {
        for (const double until = device.now + seconds; device.now < until - 1e-9;) {
            device.now += ForceWriter::cycle;
            if (posts) {
                writer.reads();
                writer.post(levels, device.now);
            }
            writer.step(device.now);
            each();
        }
    }
    EffectDevice device;
    ForceWriter writer;
    std::function<void()> each = [] {};
};

void write(const QString& file, const QByteArray& line) {
    QDir().mkpath(QFileInfo(file).path());
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(line + '\n');
}

} // namespace

class TestForceFeedback : public QObject {
    Q_OBJECT
private slots:
    void directionsAreThoseOfTheKernel_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("direction");
        QTest::newRow("to the user") << 0.0 << -1.0 << 0x0000;
        QTest::newRow("left") << -1.0 << 0.0 << 0x4000;
        QTest::newRow("away") << 0.0 << 1.0 << 0x8000;
        QTest::newRow("right") << 1.0 << 0.0 << 0xc000;
        QTest::newRow("left and to the user") << -0.5 << -0.5 << 0x2000;
        QTest::newRow("right and to the user") << 0.5 << -0.5 << 0xe000;
        QTest::newRow("almost to the user") << 1e-6 << -1.0 << 0x0000;
    }
    void directionsAreThoseOfTheKernel() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, direction);
        const EffectLevels levels = encoded(pushing({x, y, 0.0}), usualMap(), stick);
        QCOMPARE(static_cast<int>(levels.direction), direction);
        QCOMPARE(static_cast<int>(levels.level), static_cast<int>(std::lround(std::hypot(x, y) * 32767.0)));
    }

    /// Whatever the force: the stick gets it, to half a step of either value, and no more than the ceiling.
    void aForceComesBackFromItsCode() {
        QVERIFY(rc::check([] {
            const auto part = [] { return *rc::gen::inRange(-2000, 2001) * 1e-3; };
            const glm::dvec3 force(part(), part(), part());
            const double ceiling = *rc::gen::inRange(1, 1001) * 1e-3;
            const EffectLevels levels = encoded(pushing(force, ceiling), usualMap(), stick);
            const double size = glm::length(force);
            const glm::dvec3 limited = size > ceiling ? force * (ceiling / size) : force;
            const glm::dvec2 got = decoded(levels.direction, levels.level);
            const double step = 0.5 / 32767.0 + std::numbers::pi / 65536.0 * glm::length(limited);
            RC_ASSERT(glm::distance(got, glm::dvec2(limited)) <= step + 1e-12);
            RC_ASSERT(levels.level >= 0 && levels.level <= std::lround(ceiling * 32767.0));
            RC_ASSERT(levels.ceiling == std::lround(ceiling * 65535.0));
        }));
    }

    void anAxisPushesAlongTheMotionThatItMakes() {
        AxisMap map = usualMap();
        const glm::dvec3 force(0.1, 0.2, 0.4);
        QCOMPARE(stickForce(force, map, 2), glm::dvec2(0.1, 0.2));
        QCOMPARE(stickForce(force, map, 1), glm::dvec2(0.1, 0.0)); // a wheel
        map.axes[1].motion = AxisMotion::z;                        // up where the stick is pulled, as a pilot's
        map.axes[1].reversed = false;
        QCOMPARE(stickForce(force, map, 2), glm::dvec2(0.1, -0.4));
        map.axes[0].reversed = true;
        QCOMPARE(stickForce(force, map, 2), glm::dvec2(-0.1, -0.4));
        map.axes[0].motion = AxisMotion::c;
        map.axes[1].motion = AxisMotion::none;
        QCOMPARE(stickForce(force, map, 2), glm::dvec2(0.0));
    }

    void aPadShowsContactAndLoadAStickWhatItCannotPush() {
        Assist assist = pushing({0.3, 0.0, -0.4}, 0.8);
        assist.contact = 0.25;
        assist.load = 2.0; // limited
        const EffectLevels rumble = encoded(assist, usualMap(), pad);
        QCOMPARE(static_cast<int>(rumble.strong), 16384);
        QCOMPARE(static_cast<int>(rumble.weak), 52428);
        QCOMPARE(static_cast<int>(rumble.level), 0);
        const EffectLevels both = encoded(assist, usualMap(), {.rumble = true, .forceAxes = 2});
        QCOMPARE(static_cast<int>(both.level), 9830);
        QCOMPARE(static_cast<int>(both.strong), 26214); // 0.4, downwards
        QCOMPARE(static_cast<int>(both.weak), 0);
        QCOMPARE(encoded(assist, usualMap(), {.rumble = true, .forceAxes = 2, .permitted = false}), EffectLevels{});
        assist.ceiling = 0.0;
        QCOMPARE(encoded(assist, usualMap(), pad), EffectLevels{});
    }

    void whatIsNoNumberIsNothing() {
        for (const double bad : {nan, inf, -inf, -1.0}) {
            Assist assist = pushing({bad == -1.0 ? nan : bad, 0.5, 0.0});
            assist.contact = assist.load = bad;
            QCOMPARE(static_cast<int>(encoded(assist, usualMap(), stick).level), 0);
            const EffectLevels rumble = encoded(assist, usualMap(), pad);
            QVERIFY(bad > 0.0 || (rumble.strong == 0 && rumble.weak == 0));
            assist.ceiling = bad;
            QVERIFY(bad > 0.0 || encoded(assist, usualMap(), pad) == EffectLevels{});
        }
    }

    void whatSysfsShowsIsFound() {
        QTemporaryDir folder;
        const auto show = [&](const char* event, const char* product, const char* effects, const QByteArray& keys) {
            const QString device = folder.filePath("class/") + event + "/device";
            write(device + "/name", "Stick");
            write(device + "/uniq", "");
            write(device + "/id/vendor", "044f");
            write(device + "/id/product", product);
            write(device + "/capabilities/key", keys);
            write(device + "/capabilities/abs", "3");
            write(device + "/capabilities/ff", effects);
        };
        const QByteArray trigger = "100000000 0 0 0 0"; // BTN_TRIGGER
        // Words of 64 bits: rumble is bit 16 of the second one, constant 18, spring 19, damper 21, gain 32,
        // centring 33.
        show("event1", "0001", "2d0000 0", trigger);
        show("event2", "0002", "300000000 0", trigger);
        show("event3", "0003", "300250000 0", trigger);
        show("event4", "0004", "40000 0", "10000 100000000 0 0 0 0");
        show("event5", "0005", "0", trigger);
        QDir().mkpath(folder.filePath("drivers/logitech"));
        QDir().mkpath(folder.filePath("class/event2/device/device"));
        QVERIFY(QFile::link(folder.filePath("drivers/logitech"), folder.filePath("class/event2/device/device/driver")));
        std::map<std::string, ForceAbilities> found;
        for (const InputDevice& device : inputDevices({folder.filePath("class").toStdString(), {}}))
            found[device.id.substr(device.id.size() - 4)] = device.force;
        const ForceAbilities& all = found["0001"];
        QVERIFY(all.rumble && all.constant && all.spring && !all.autocentre && all.axes == 2);
        QVERIFY(!found["0002"].any() && found["0002"].gain && !found["0002"].autocentre); // not known what to restore
        const ForceAbilities& restored = found["0003"];
        QVERIFY(restored.rumble && restored.constant && restored.damper && restored.gain && restored.autocentre);
        QCOMPARE(found["0004"].axes, 1); // a wheel
        QVERIFY(!found["0005"].any() && !found["0005"].gain);
    }

    /// Without a further call everything ends, within the time that an effect lasts.
    void effectsEndByThemselves() {
        Written test;
        test.run(0.3, pushed(0.5));
        QVERIFY(test.device.played(FF_CONSTANT) && test.device.played(FF_SPRING) && test.device.played(FF_DAMPER));
        test.device.now += 0.1 + 1e-6; // Burin hangs
        QVERIFY(test.device.silent());
    }

    void effectsAreRenewedWithoutAGap() {
        Written test;
        test.run(0.1, pushed(0.5));
        const int uploads = test.device.uploads, starts = test.device.starts;
        test.each = [&] { QVERIFY(test.device.played(FF_CONSTANT) && test.device.played(FF_SPRING)); };
        test.run(2.0, pushed(0.5));
        QCOMPARE(test.device.uploads, uploads);         // nothing changed
        QVERIFY(test.device.starts - starts <= 3 * 51); // each of the three effects every 40 ms
        QCOMPARE(static_cast<int>(test.device.played(FF_CONSTANT)->u.constant.level), 16384);
    }

    /// Small changes are collected, so that a slow bus follows, but none is left out.
    void changesAreSentAsOftenAsABusTakesThem() {
        Written test;
        test.run(0.1, pushed(0.1));
        const int uploads = test.device.uploads;
        for (int i = 0; i < 200; ++i) test.run(0.01, pushed(0.1 + 0.004 * i)); // 2 s
        QVERIFY(test.device.uploads - uploads <= 2.0 / EffectPlayer::changeAfter + 1);
        test.run(0.2, pushed(0.896 + 0.001)); // less than 1/128
        QCOMPARE(test.device.played(FF_CONSTANT)->u.constant.level, pushed(0.897).level);
        test.run(0.01, pushed(0.0));
        QVERIFY(!test.device.played(FF_CONSTANT)); // at once
        QVERIFY(test.device.played(FF_SPRING));
    }

    void springAndDamperStayWithinTheCeiling() {
        Written test;
        test.run(0.2, pushed(0.0, 0.4));
        const auto spring = test.device.played(FF_SPRING), damper = test.device.played(FF_DAMPER);
        QVERIFY(spring && damper && !test.device.played(FF_CONSTANT) && !test.device.played(FF_RUMBLE));
        for (const ff_condition_effect& axis : spring->u.condition) {
            QCOMPARE(static_cast<int>(axis.right_saturation), 26214); // 0.4
            QCOMPARE(static_cast<int>(axis.left_saturation), 26214);
            QCOMPARE(static_cast<int>(axis.right_coeff), 16384); // 0.5
            QCOMPARE(static_cast<int>(axis.center), 0);
        }
        QCOMPARE(static_cast<int>(damper->u.condition[1].left_coeff), 8192); // 0.25
        QCOMPARE(static_cast<int>(damper->u.condition[1].left_saturation), 26214);
    }

    void centringIsOffMeanwhileAndOnAgainAfterwards() {
        Written test;
        test.run(0.1, {});
        QCOMPARE(test.device.opened, 0); // nothing is wanted: the device is left alone
        test.run(0.5, pushed(0.2));
        QCOMPARE(test.device.properties[FF_AUTOCENTER], std::vector<int>{0});
        QCOMPARE(test.device.properties[FF_GAIN], std::vector<int>{0xffff});
        test.run(1.0, {});
        QCOMPARE(test.device.properties[FF_AUTOCENTER], (std::vector<int>{0, 0xffff}));
        QVERIFY(!test.device.isOpen() && test.device.kept() == 0);
        test.run(0.5, pushed(0.2));
        test.writer.close();
        QCOMPARE(test.device.properties[FF_AUTOCENTER], (std::vector<int>{0, 0xffff, 0, 0xffff}));
        QVERIFY(test.device.silent());
    }

    /// Without a spring of its own a limp stick would go on moving the tool.
    void withoutASpringItGoesOnCentring() {
        Written none(ForceAbilities{.constant = true, .autocentre = true, .axes = 2});
        none.run(0.5, pushed(0.2));
        QVERIFY(none.device.played(FF_CONSTANT) && none.device.properties.empty());
        Written noRoom;
        noRoom.device.room = 1;
        noRoom.run(0.5, pushed(0.2));
        QVERIFY(noRoom.device.played(FF_CONSTANT) && noRoom.device.properties[FF_AUTOCENTER].empty());
        QVERIFY(!noRoom.writer.takeFault());
    }

    void aLoopThatStandsShowsNothing() {
        Written test;
        test.run(0.3, pushed(0.5));
        test.run(ForceWriter::staleAfter + 2.0 * ForceWriter::cycle, {}, false);
        QVERIFY(test.device.silent());
        test.run(0.1, pushed(0.5));
        QVERIFY(test.device.played(FF_CONSTANT));
    }

    /// Levels that belong to a reading made before the cut must not come through, however late they are posted.
    void aCutHoldsUntilTheNextReading() {
        Written test;
        test.run(0.3, pushed(0.5));
        test.writer.reads();
        test.writer.cut();
        test.writer.post(pushed(0.5), test.device.now);
        test.device.now += ForceWriter::cycle;
        test.writer.step(test.device.now);
        QVERIFY(test.device.silent());
        test.run(0.02, pushed(0.5));
        QVERIFY(test.device.played(FF_CONSTANT));
    }

    void anUnpluggedDeviceIsFoundAgain() {
        Written test;
        test.run(0.3, pushed(0.5));
        test.device.there = false;
        test.run(1.0, pushed(0.5));
        QVERIFY(test.device.silent() && !test.device.isOpen() && test.device.kept() == 0);
        QVERIFY(!test.writer.takeFault()); // the thread that reads it reports that
        test.device.there = true;
        test.run(0.6, pushed(0.5));
        QVERIFY(test.device.played(FF_CONSTANT));
    }

    void faultsAreReportedOnce() {
        Written deaf;
        deaf.run(0.3, pushed(0.5));
        deaf.device.writeFault = EIO;
        deaf.run(3.0, pushed(0.5));
        const auto fault = deaf.writer.takeFault();
        QVERIFY(fault && fault->code == ErrorCode::deviceStopped && fault->subject == "stick");
        QVERIFY(!deaf.writer.takeFault());
        deaf.device.writeFault = 0;
        deaf.run(0.6, pushed(0.5));
        QVERIFY(deaf.device.played(FF_CONSTANT));
        Written denied;
        denied.device.openFault = EACCES;
        denied.run(3.0, pushed(0.5));
        const auto refused = denied.writer.takeFault();
        QVERIFY(refused && refused->code == ErrorCode::deviceAssistDenied && refused->place == "/dev/input/event7");
        QVERIFY(!denied.writer.takeFault());
    }

    void theTickNeitherAllocatesNorWaits() {
        EffectDevice device;
        auto writer = std::make_unique<ForceWriter>(device.opener(), everything, "stick", "node");
        AssistedStylus stylus(std::make_unique<StillStylus>(), std::move(writer), stick);
        QCOMPARE(stylus.description().assist.forceAxes, 2);
        QCOMPARE(stylus.description().name, std::string("still"));
        Wrench wrench;
        wrench.assist = pushing({0.0, 0.5, 0.0});
        const std::size_t before = allocationCount;
        for (int i = 0; i < 10'000; ++i) {
            stylus.read(0.001 * i);
            stylus.write(wrench);
        }
        QCOMPARE(allocationCount.load(), before);
        QCOMPARE(device.opened, 0); // no thread runs
    }

    /// With the thread, in real time: shown while the loop runs, gone when it is closed.
    void aStylusShowsWhatTheLoopWants() {
        EffectDevice device; // its time stands still: effects last until they are stopped
        std::atomic<int> opened{0};
        const OpenEffectPort open = [&, inner = device.opener()](int& fault) {
            ++opened;
            return inner(fault);
        };
        AssistedStylus stylus(std::make_unique<StillStylus>(),
                              std::make_unique<ForceWriter>(open, everything, "stick", "node"), stick);
        QVERIFY(stylus.open().hasValue());
        Wrench wrench;
        wrench.assist = pushing({0.0, 0.5, 0.0});
        const auto tick = [&] {
            stylus.read(0.0);
            stylus.write(wrench);
            return opened > 0;
        };
        QVERIFY(comesTrue(tick));
        stylus.close();
        QVERIFY(!device.isOpen() && device.silent() && device.kept() == 0);
        QCOMPARE(device.properties[FF_AUTOCENTER], (std::vector<int>{0, 0xffff}));
        QVERIFY(!stylus.takeFault());
    }

    void whoMayNotWriteIsTold() {
        EffectDevice device;
        AssistedStylus stylus(std::make_unique<StillStylus>(),
                              std::make_unique<ForceWriter>(device.opener(), everything, "stick", "/dev/input/event7"),
                              {.rumble = true, .forceAxes = 2, .permitted = false});
        QVERIFY(!stylus.description().assist.works());
        QVERIFY(stylus.open().hasValue()); // it can still be milled with
        const auto fault = stylus.takeFault();
        QVERIFY(fault && fault->code == ErrorCode::deviceAssistDenied && !stylus.takeFault());
        QVERIFY(stylus.read(0.0).valid);
    }
};

BURIN_TEST(TestForceFeedback, NoApplication)

} // namespace burin::tst_force_feedback

#include "tst_force_feedback.moc"
