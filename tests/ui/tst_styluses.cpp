// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/own_stylus.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "ui/workbench/workbench.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <mutex>

namespace burin::tst_styluses {

using burin::test::OwnStylus;

namespace {

/// What a test's devices are doing. Thread-safe.
struct Hand {
    std::atomic<bool> pluggedIn{true}, button{false}, secondButton{false};
    std::atomic<bool> aside{false}; ///< it rests beside its centre; otherwise it moves in a circle
    std::atomic<OwnStylus*> stylus{nullptr};
};

StylusDescription description(bool motors) {
    StylusDescription description = test::desktopStylus();
    description.name = "Arm";
    description.buttons = 2;
    description.rate = {1000.0, "made up"};
    if (motors) return description;
    description.actuated = {};
    description.maximumForce = {};
    description.maximumStiffness = {};
    description.maximumDamping = {};
    return description;
}

class Arms final : public DeviceDriver {
public:
    explicit Arms(Hand& hand) : hand_(hand) {}
    std::vector<FoundDevice> find() override {
        const std::lock_guard lock(mutex_);
        return devices_;
    }
    void put(std::vector<FoundDevice> devices) {
        const std::lock_guard lock(mutex_);
        devices_ = std::move(devices);
    }
    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        madeMode = mode;
        if (id != "one") return Error{ErrorCode::deviceNotAllowed, id, "/dev/none", {}};
        auto stylus = std::make_unique<OwnStylus>(description(motors), [&hand = hand_](double time, int) {
            StylusState state;
            state.time = time;
            state.pose.position = {20.0 * std::sin(3.0 * time), 5.0 * std::cos(3.0 * time), -8.0};
            if (hand.aside) state.pose.position = {12.0, 0.0, 0.0};
            state.buttons = (hand.button ? 1U : 0U) | (hand.secondButton ? 2U : 0U);
            state.valid = hand.pluggedIn;
            return state;
        });
        hand_.stylus = stylus.get();
        return AnyStylus(std::unique_ptr<SelfPacedStylus>(std::move(stylus)));
    }
    std::string madeMode;
    bool motors = true;

private:
    Hand& hand_;
    std::mutex mutex_;
    std::vector<FoundDevice> devices_;
};

struct Shelf {
    Shelf() {
        auto made = std::make_unique<Arms>(hand);
        arms = made.get();
        registry->add("arms", std::move(made));
    }
    QTemporaryDir folder;
    Hand hand;
    std::shared_ptr<DeviceRegistry> registry =
        std::make_shared<DeviceRegistry>(std::filesystem::path(folder.path().toStdString()) / "none");
    Arms* arms;
};

/// Waits until a cube is embedded and the arm is the stylus.
bool takeInHand(Shelf& shelf, Workbench& workbench) {
    shelf.arms->put({{"one", "Arm", {}}});
    workbench.document.createNew(false, [&](bool made) {
        if (made) workbench.importPart(BURIN_FIXTURES "/models/cube.brep", false);
    });
    if (!QTest::qWaitFor([&] { return workbench.setup.usable(); }, 60000)) return false;
    Setup coarse = workbench.setup.setup();
    coarse.voxel = 1.0; // mm: embedded quickly
    workbench.setup.edit(coarse);
    workbench.workpiece.embed();
    if (!QTest::qWaitFor([&] { return workbench.workpiece.ready(); }, 60000)) return false;
    workbench.styluses.start(shelf.registry);
    if (!QTest::qWaitFor([&] { return workbench.styluses.choices().size() == 2; }, 30000)) return false;
    workbench.styluses.choose(1);
    workbench.mill.enter();
    return QTest::qWaitFor([&] { return workbench.mill.active() && workbench.session.state().ticks > 50; }, 30000);
}

QStringList namesOf(const StylusController& styluses) {
    QStringList names;
    for (const StylusController::Choice& choice : styluses.choices())
        names << choice.name + (choice.there ? "" : " (away)");
    return names;
}

} // namespace

/// Which stylus the window mills with, and that a device can mill.
class TestStyluses : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
        QCoreApplication::setApplicationName("Burin");
    }

    void devicesComeAndGo() {
        Shelf shelf;
        Workbench workbench;
        StylusController& styluses = workbench.styluses;
        QCOMPARE(namesOf(styluses), QStringList{"Mouse"});
        styluses.start(shelf.registry);
        const DeviceMode fast{"fast", BURIN_TEXT("Device", "quick")}, slow{"slow", BURIN_TEXT("Device", "calm")};
        shelf.arms->put({{"one", "Arm", {}}, {"two", "Cap", {fast, slow}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: quick", "Cap: calm"}));
        QVERIFY(styluses.mouse());
        styluses.choose(3);
        QCOMPARE(styluses.chosenName(), QString("Cap: calm"));
        styluses.choose(9); // there is no such stylus
        QCOMPARE(styluses.chosen(), std::size_t{3});
        shelf.arms->put({{"one", "Arm", {}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: calm (away)"}));
        QCOMPARE(styluses.chosen(), std::size_t{2}); // the choice is kept
        shelf.arms->put({{"one", "Arm", {}}, {"two", "Cap", {fast, slow}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: quick", "Cap: calm"}));
        QCOMPARE(styluses.chosenName(), QString("Cap: calm"));
        shelf.arms->put({});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Cap: calm (away)"}));
        styluses.choose(0);
        QCOMPARE(namesOf(styluses), QStringList{"Mouse"});
    }

    void aDeviceThatCannotBeUsedSaysSo() {
        Shelf shelf;
        Workbench workbench;
        workbench.styluses.start(shelf.registry);
        shelf.arms->put({{"two", "Cap", {}}});
        QTRY_COMPARE(workbench.styluses.choices().size(), std::size_t{2});
        workbench.styluses.choose(1);
        QSignalSpy failed(&workbench, &Workbench::failed);
        bool told = false;
        workbench.styluses.connectDevice([&](std::unique_ptr<AnyStylus> stylus) { told = stylus == nullptr; });
        QTRY_VERIFY(told);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(qvariant_cast<Error>(failed[0][0]).code, ErrorCode::deviceNotAllowed);
    }

    /// The device's button begins a stroke and its recording. Unplugging is reported, and milling goes on when it is
    /// back.
    void aDeviceMills() {
        Shelf shelf;
        Workbench workbench;
        QSignalSpy failed(&workbench, &Workbench::failed);
        QVERIFY(takeInHand(shelf, workbench));
        QVERIFY(!workbench.mill.stylus()); // it is not the pointer
        QVERIFY(!workbench.mill.recording());
        shelf.hand.button = true;
        QTRY_VERIFY(workbench.mill.recording());
        QTRY_VERIFY(workbench.session.state().cutting);

        shelf.hand.pluggedIn = false;
        shelf.hand.stylus.load()->faults.raise(DeviceFault::unplugged);
        const auto unplugged = [&failed] {
            return std::ranges::any_of(failed, [](const QVariantList& told) {
                return qvariant_cast<Error>(told[0]).code == ErrorCode::deviceUnplugged;
            });
        };
        QTRY_VERIFY(unplugged());
        QTRY_VERIFY((workbench.session.state().sample.flags & sampleStylusInvalid) != 0);
        QCOMPARE(workbench.session.state().sample.force, glm::dvec3(0.0));
        QVERIFY(workbench.mill.active());
        shelf.hand.pluggedIn = true;
        QTRY_VERIFY((workbench.session.state().sample.flags & sampleStylusInvalid) == 0);
        QTRY_VERIFY(workbench.session.state().cutting);

        workbench.mill.stopRecording();
        QTRY_VERIFY(!workbench.mill.recording());
        QTest::qWait(100);
        QVERIFY(!workbench.mill.recording()); // a button that is still held begins no stroke
        workbench.mill.leave();
        QTRY_VERIFY(!workbench.mill.active());
        QTRY_COMPARE(workbench.mill.takes().size(), std::size_t{1});
        QCOMPARE(workbench.mill.takes()[0].stylus, std::string("Arm"));
        QVERIFY(workbench.mill.takes()[0].sampleCount > 0);
    }

    /// The settings stay with the device and can be undone.
    void theHandIsScaledAndClutched() {
        Shelf shelf;
        Workbench workbench;
        QVERIFY(takeInHand(shelf, workbench));
        HandController& hand = workbench.hand;
        const SessionState& state = workbench.session.state();
        const double first = state.workspaceScale;
        hand.setScale(2.0 * first);
        QTRY_VERIFY(std::abs(state.workspaceScale - 2.0 * first) < 1e-9);
        workbench.mill.leave();
        QTRY_VERIFY(!workbench.mill.active());
        workbench.mill.enter();
        QTRY_VERIFY(workbench.mill.active());
        QTRY_VERIFY(std::abs(state.workspaceScale - 2.0 * first) < 1e-9);
        workbench.undoLast();
        QTRY_VERIFY(std::abs(state.workspaceScale - first) < 1e-9);
        QVERIFY(!hand.canRate()); // the motors would push it away from its position

        hand.setClutched(true);
        QTRY_VERIFY(state.clutched);
        QTest::qWait(600); // so that motion under way comes to its end
        const glm::dvec3 rest = state.sample.stylusTip;
        const glm::dvec3 place = state.sample.device.position;
        QTRY_VERIFY(glm::distance(state.sample.device.position, place) > 5.0); // the device goes on moving
        QVERIFY(glm::distance(state.sample.stylusTip, rest) < 0.05);
        hand.setClutched(false);
        QTRY_VERIFY(!state.clutched);
        hand.setClutchButton(2);
        QVERIFY(!state.clutched);
        shelf.hand.secondButton = true;
        QTRY_VERIFY(state.clutched);
        shelf.hand.secondButton = false;
        QTRY_VERIFY(!state.clutched);
    }

    void aDeadMansSwitchKeepsForcesOff() {
        constexpr int patience = 20000; // ms: forces fade in by ticks, which are late on a busy machine
        Shelf shelf;
        Workbench workbench;
        QVERIFY(takeInHand(shelf, workbench));
        const SessionState& state = workbench.session.state();
        QTRY_VERIFY_WITH_TIMEOUT((state.sample.flags & sampleForcesOff) == 0, patience); // they have faded in
        workbench.hand.setForceButton(2);
        QTRY_VERIFY_WITH_TIMEOUT(
            workbench.mill.active() && state.ticks > 100 && (state.sample.flags & sampleForcesOff) != 0, patience);
        QTest::qWait(2500); // longer than forces take to fade in
        QVERIFY((state.sample.flags & sampleForcesOff) != 0);
        QCOMPARE(state.sample.force, glm::dvec3(0.0));
        shelf.hand.secondButton = true;
        QTRY_VERIFY_WITH_TIMEOUT((state.sample.flags & sampleForcesOff) == 0, patience);
        shelf.hand.secondButton = false;
        QTRY_VERIFY_WITH_TIMEOUT((state.sample.flags & sampleForcesOff) != 0, patience);
        workbench.undoLast();
        QTRY_VERIFY_WITH_TIMEOUT(workbench.mill.active() && (state.sample.flags & sampleForcesOff) == 0, patience);
    }

    void aStylusWithoutMotorsMaySetTheSpeed() {
        Shelf shelf;
        shelf.arms->motors = false;
        shelf.hand.aside = true;
        Workbench workbench;
        QVERIFY(takeInHand(shelf, workbench));
        QVERIFY(workbench.hand.canRate());
        const SessionState& state = workbench.session.state();
        const glm::dvec3 rest = state.sample.stylusTip;
        QTest::qWait(200);
        QCOMPARE(state.sample.stylusTip, rest); // the device rests, and so does the tool
        workbench.hand.setControl(WorkspaceControl::rate);
        QTRY_VERIFY(state.sample.stylusTip.x > rest.x + 5.0); // it goes on as long as the device is off-centre
        const Box region = workbench.workpiece.milling()->tipRegion();
        QTest::qWait(3000);
        QVERIFY(region.grown(1e-9).contains(state.sample.stylusTip)); // but does not leave the region
        workbench.undoLast();
        QTest::qWait(100);
        const glm::dvec3 stopped = state.sample.stylusTip;
        QTest::qWait(200);
        QCOMPARE(state.sample.stylusTip, stopped);
    }

    void aDeviceWhoseBatteryIsLowIsToldOnce() {
        Shelf shelf;
        Workbench workbench;
        QVERIFY(takeInHand(shelf, workbench));
        QSignalSpy low(&workbench.hand, &HandController::batteryLow);
        OwnStylus& arm = *shelf.hand.stylus.load();
        arm.battery = 0.4;
        arm.heat = 0.5;
        QTRY_VERIFY(workbench.hand.health().batteryShare && *workbench.hand.health().motorHeat > 0.4);
        QCOMPARE(low.size(), 0);
        arm.battery = 0.12;
        QTRY_COMPARE(low.size(), 1);
        QCOMPARE(low[0][0].toDouble(), 0.12);
        arm.battery = 0.11;
        QTest::qWait(700);
        QCOMPARE(low.size(), 1);
        arm.battery = 0.5; // charged, and low again
        QTRY_VERIFY(*workbench.hand.health().batteryShare > 0.4);
        arm.battery = 0.1;
        QTRY_COMPARE(low.size(), 2);
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
};

BURIN_TEST(TestStyluses, QCoreApplication)

} // namespace burin::tst_styluses

#include "tst_styluses.moc"
