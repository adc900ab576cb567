// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/stylus_handle.h"
#include "plugins/devices/force_dimension/dhd_stylus.h"
#include "plugins/devices/force_dimension/driver.h"
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/plugins/stand_ins/dhd_stand_in.h"
#include "tests/plugins/stand_ins/stand_in.h"
#include "tests/plugins/through_driver.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_forcedimension {

using namespace burin::test;
using burin::testing::DhdDevice;
using burin::testing::DhdStandIn;
using burin::testing::inLongRun;

namespace {

const QString standIns = BURIN_BUILD_DIRECTORY "/stand-ins/";
constexpr double millimetre = 0.001;

DhdStandIn& dhdStandIn() {
    static DhdStandIn& instance = burin::testing::standInOf<DhdStandIn>(
        BURIN_BUILD_DIRECTORY "/stand-ins/force-dimension/libdrd.so", "burinDhdStandIn");
    return instance;
}

/// Sets a position, converted from Burin's device frame, mm, to the library's, m.
void moveTo(DhdDevice& device, const glm::dvec3& place) {
    device.place = {-millimetre * place.y, millimetre * place.x, millimetre * place.z};
}

glm::dvec3 felt(const DhdDevice& device) {
    const auto force = device.force();
    return {force[1], -force[0], force[2]};
}

Wrench upward(double newtons) {
    Wrench wrench;
    wrench.force.z = newtons;
    return wrench;
}

} // namespace

/// The driver for Force Dimension's devices, with a stand-in for libdrd. No real device was available.
class TestForceDimension : public QObject {
    Q_OBJECT
    std::unique_ptr<DeviceDriver> driver_;
    double time_ = 0.0;

    DhdDevice& plug(const DhdDevice& device = {}) {
        dhdStandIn().devices.push_back(device);
        return dhdStandIn().devices.back();
    }
    std::unique_ptr<Stylus> stylus(const char* id = "0", const char* mode = "") {
        auto made = driver_->make(id, mode);
        if (!made) return nullptr;
        return std::move(std::get<std::unique_ptr<Stylus>>(*made));
    }
    StylusState tick(Stylus& stylus, const Wrench& wrench) {
        time_ += 0.001;
        const StylusState state = stylus.read(time_);
        stylus.write(state.valid ? wrench : Wrench{});
        return state;
    }

private slots:
    void init() {
        dhdStandIn().devices.clear();
        dhdStandIn().devices.reserve(4); // so that references stay valid
        dhdStandIn().complaints.clear();
        qputenv("FDSDK", (standIns + "force-dimension").toUtf8());
        driver_ = forcedimension::makeDriver();
        time_ = 0.0;
    }
    void cleanup() {
        driver_.reset();
        for (const std::string& complaint : dhdStandIn().complaints) qWarning("%s", complaint.c_str());
        QVERIFY(dhdStandIn().complaints.empty());
    }

    void devicesAreCounted() {
        QVERIFY(driver_->find().empty());
        plug();
        plug();
        const auto found = driver_->find();
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[1].id, std::string("1"));
        QCOMPARE(found[1].modes.size(), std::size_t{2});
        QVERIFY(!dhdStandIn().devices[0].open); // enumerating devices does not open any
        QCOMPARE(driver_->make("2", {}).error().code, ErrorCode::deviceNotFound);
        QCOMPARE(driver_->make("-1", {}).error().code, ErrorCode::deviceNotFound);
        QCOMPARE(driver_->make("0", "other").error().code, ErrorCode::nameUnknown);
    }

    void aLibraryThatIsMissingOrTooOldIsSaid() {
        QTemporaryDir empty;
        qputenv("FDSDK", empty.path().toUtf8());
        QCOMPARE(forcedimension::makeDriver()->ready().error().code, ErrorCode::deviceLibraryMissing);
        qputenv("FDSDK", (standIns + "force-dimension-old").toUtf8());
        const auto old = forcedimension::makeDriver()->ready();
        QCOMPARE(old.error().code, ErrorCode::deviceLibraryUnfit);
        QCOMPARE(old.error().place, std::string("3.15.5"));
    }

    void aDeviceSaysWhatItBears() {
        DhdDevice sigma;
        sigma.type = 104;
        sigma.name = "sigma.7";
        sigma.wrist = sigma.activeWrist = sigma.gripper = true;
        plug(sigma);
        const StylusDescription told = stylus()->description();
        QCOMPARE(told.name, std::string("sigma.7"));
        QVERIFY(told.sensed == (Freedoms{3, 3}) && told.actuated == (Freedoms{3, 3}));
        QCOMPARE(told.maximumForce.value, 12.0);
        QCOMPARE(told.maximumTorque.value, 200.0); // N·mm
        QVERIFY(checkDescription(told));
        DhdDevice lambda; // a device whose wrist stiffness is unknown
        lambda.type = 108;
        lambda.wrist = lambda.activeWrist = true;
        plug(lambda);
        QVERIFY(stylus("1")->description().actuated == (Freedoms{3, 0}));
        DhdDevice unknown;
        unknown.type = 999;
        plug(unknown);
        QCOMPARE(driver_->make("2", {}).error().code, ErrorCode::deviceFault);
        QVERIFY(!dhdStandIn().devices[2].open);
    }

    void itsOwnGuardsAreSetBeforeItsForces() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        QCOMPARE(device.maximumForce, 12.0);
        QCOMPARE(device.watchdog * 0.125, 20.0); // ms
        QVERIFY(device.gravity == 1 && device.brakes == 1 && device.forcesOn);
        QVERIFY(!pen->open());
        tick(*pen, upward(2.0));
        QCOMPARE(felt(device).z, 2.0);
        pen->close();
        QVERIFY(!device.forcesOn);
        QCOMPARE(device.asked[2], 0.0);
    }

    void posesAndForcesAreTurnedIntoOurFrame() {
        DhdDevice omega;
        omega.type = 34;
        omega.wrist = true;
        DhdDevice& device = plug(omega);
        const auto pen = stylus();
        QVERIFY(pen->open());
        device.place = {0.010, 0.020, 0.030}; // towards the user, right, up
        // The pen, along x at rest, is rotated by a quarter turn about y: its back end points up.
        device.rotation = {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}};
        device.buttons = 1;
        Wrench wrench;
        wrench.force = {1.0, 2.0, 3.0};
        wrench.torque = {4.0, 5.0, 6.0};
        const StylusState state = tick(*pen, wrench);
        QVERIFY(state.valid);
        QVERIFY(glm::distance(state.pose.position, glm::dvec3(20.0, -10.0, 30.0)) < 1e-12);
        QVERIFY(glm::distance(toolPose(state.pose).axis, glm::dvec3(0, 0, 1)) < 1e-12);
        QCOMPARE(state.buttons, 1U);
        QCOMPARE(device.asked, (std::array{-2.0, 1.0, 3.0, 0.0, 0.0, 0.0})); // its wrist has no motors
    }

    void torqueIsInNewtonMetres() {
        DhdDevice sigma;
        sigma.type = 104;
        sigma.wrist = sigma.activeWrist = true;
        DhdDevice& device = plug(sigma);
        const auto pen = stylus();
        QVERIFY(pen->open());
        Wrench wrench;
        wrench.torque = {40.0, 50.0, 60.0}; // N·mm
        tick(*pen, wrench);
        QCOMPARE(device.asked, (std::array{0.0, 0.0, 0.0, -0.05, 0.04, 0.06}));
    }

    void aHandWithoutAWristHoldsTheToolUpright() {
        plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        QCOMPARE(toolPose(tick(*pen, {}).pose).axis, glm::dvec3(0, 0, 1));
        QCOMPARE(pen->description().sensed.rotations, 0);
    }

    void itMovesByItselfOnlyWhereThatWasChosen() {
        DhdDevice fresh;
        fresh.initialised = false;
        DhdDevice& device = plug(fresh);
        const auto careful = stylus()->open();
        QVERIFY(!careful);
        QCOMPARE(careful.error().code, ErrorCode::deviceFault);
        QCOMPARE(device.autoInitialisations, 0);
        device.canInitialise = false;
        QVERIFY(!stylus("0", "self_calibrating")->open());
        device.canInitialise = true;
        const auto pen = stylus("0", "self_calibrating");
        QVERIFY(pen->open());
        QVERIFY(device.initialised && !device.regulated && device.forcesOn);
        QVERIFY(tick(*pen, {}).valid);
    }

    void everyCutOfTheDeviceIsSaidAndItsForcesFadeIn_data() {
        QTest::addColumn<int>("cause");
        QTest::addColumn<int>("fault");
        QTest::addColumn<bool>("byHand");
        const auto row = [](const char* name, int cause, DeviceFault fault, bool byHand) {
            QTest::newRow(name) << cause << static_cast<int>(fault) << byHand;
        };
        row("button", 1, DeviceFault::stopped, true);
        row("speed", 2, DeviceFault::tooFast, false);
        row("watchdog", 3, DeviceFault::watchdog, false);
        row("usb", 5, DeviceFault::deaf, false);
        row("dead man", 6, DeviceFault::stopped, true);
    }
    void everyCutOfTheDeviceIsSaidAndItsForcesFadeIn() {
        QFETCH(int, cause);
        QFETCH(int, fault);
        QFETCH(bool, byHand);
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        for (int i = 0; i < 30; ++i) QVERIFY(tick(*pen, upward(1.0)).valid);
        device.cut(cause);
        StylusState state;
        for (int i = 0; i < forcedimension::DhdStylus::readingsBetweenChecks; ++i) {
            state = tick(*pen, upward(1.0));
            QCOMPARE(felt(device).z, 0.0);
        }
        QVERIFY(!state.valid);
        const auto told = pen->takeFault();
        const Error expected = errorOf(static_cast<DeviceFault>(fault), "omega.3");
        QVERIFY(told && told->code == expected.code && told->detail == expected.detail);
        for (int i = 0; i < 600; ++i) state = tick(*pen, upward(1.0));
        if (byHand) {
            QVERIFY(!state.valid && !device.forcesOn && device.forcesSwitchedOn == 1);
            device.forcesOn = true; // as by hand
            for (int i = 0; i < 20; ++i) state = tick(*pen, upward(1.0));
        }
        QVERIFY(state.valid);
        QCOMPARE(felt(device).z, 1.0);
        QVERIFY(!pen->takeFault());
    }

    void aReadingThatFailsTakesTheForceAway() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        tick(*pen, upward(1.0));
        device.failingReads = 1;
        QVERIFY(!tick(*pen, upward(1.0)).valid);
        QCOMPARE(felt(device).z, 0.0);
        QVERIFY(tick(*pen, upward(1.0)).valid);
        device.place[0] = NAN;
        QVERIFY(!tick(*pen, upward(1.0)).valid);
        QCOMPARE(felt(device).z, 0.0);
        device.place[0] = 0.0;
        device.deaf = true;
        tick(*pen, upward(1.0));
        QCOMPARE(pen->takeFault()->detail, deviceReasons[static_cast<std::size_t>(DeviceFault::deaf)].text);
    }

    void unpluggedItIsFoundAgain() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        const auto plugged = [&](bool there) {
            const std::lock_guard lock(dhdStandIn().mutex);
            device.plugged = there;
        };
        plugged(false);
        for (int i = 0; i < 25; ++i) QVERIFY(!tick(*pen, upward(1.0)).valid);
        QCOMPARE(pen->takeFault()->code, ErrorCode::deviceUnplugged);
        QVERIFY(!pen->health().connected);
        QTest::qWait(700);
        device.type = 63; // another model in its place is not accepted
        plugged(true);
        QTest::qWait(700);
        QVERIFY(!pen->health().connected);
        {
            const std::lock_guard lock(dhdStandIn().mutex);
            device.type = 33;
        }
        QTRY_VERIFY(pen->health().connected);
        QVERIFY(tick(*pen, upward(1.0)).valid);
        QCOMPARE(felt(device).z, 1.0);
    }

    void theLoopsWatchdogCutsFromOutside() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        tick(*pen, upward(1.0));
        QVERIFY(pen->read(0.1).valid); // and the tick hangs
        std::thread([&] { pen->cutMotors(); }).join();
        QCOMPARE(felt(device).z, 0.0);
        pen->write(upward(1.0));
        QCOMPARE(device.asked[2], 0.0);
        device.asked[2] = 1.0; // as if the zero force had been lost
        QVERIFY(pen->read(0.2).valid);
        QVERIFY(device.forcesOn && device.asked[2] == 0.0); // on again, starting from zero force
        tick(*pen, upward(1.0));
        QCOMPARE(felt(device).z, 1.0);
    }

    void aContactGivesNoEnergy_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("encoder");
        QTest::newRow("omega.3") << 33 << 0.25 << 0.009; // Force Dimension's data sheet: < 0.01 mm
        QTest::newRow("delta.3") << 63 << 0.3 << 0.02;
        QTest::newRow("Falcon") << 60 << 0.12 << 0.064; // 400 dpi
    }
    void aContactGivesNoEnergy() {
        QFETCH(int, type);
        QFETCH(double, mass);
        QFETCH(double, encoder);
        DhdDevice model;
        model.type = type;
        DhdDevice& device = plug(model);
        const auto pen = stylus();
        QVERIFY(pen->open());
        for (const SimulatedGrip& grip : {lightGrip, middleGrip, firmGrip}) {
            HapticSettings settings;
            settings.stylus = pen->description();
            settings.rampSeconds = 0.0;
            Rig rig(settings, ballTool(), stockOnPart(0, false));
            StepClient client(rig.step);
            SimulatedMechanism mechanism;
            mechanism.mass = mass;
            mechanism.encoder = encoder;
            double most = 0.0;
            const double energy = energyPerContact(grip, mechanism, [&](const glm::dvec3& reading, std::uint32_t) {
                moveTo(device, reading);
                time_ += period;
                pen->write(client.tick(pen->read(time_)));
                most = std::max(most, felt(device).z);
                return felt(device);
            });
            qInfo("%.4f mJ a contact, at most %.2f N", 1e3 * energy, most);
            QVERIFY2(1e3 * energy <= 0.02, qPrintable(QString::number(1e3 * energy)));
            QVERIFY(most > 0.1);
        }
    }

    void hostileReadingsStayWithinTheLimits() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        HapticSettings settings;
        settings.stylus = pen->description();
        settings.rampSeconds = 0.05;
        settings.felt.gain = 100.0;
        Rig rig(settings, ballTool(5.0, 12.0));
        StepClient client(rig.step);
        const QString said = hostileReadings(pen->description(), settings.forceShare, inLongRun(1'000'000, 100'000),
                                             [&](const glm::dvec3& reading, std::uint32_t buttons) {
                                                 moveTo(device, reading);
                                                 device.buttons = buttons;
                                                 time_ += period;
                                                 pen->write(client.tick(pen->read(time_)));
                                                 return felt(device);
                                             });
        QVERIFY2(said.isEmpty(), qPrintable(said));
    }

    void aSessionComesOutOfItsTrace() {
        DhdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        const QString said = sessionThroughDriver(*pen, [&](const glm::dvec3& place) {
            const std::lock_guard lock(dhdStandIn().mutex);
            moveTo(device, place);
        });
        QVERIFY2(said.isEmpty(), qPrintable(said));
    }
};

BURIN_TEST(TestForceDimension, QCoreApplication)

} // namespace burin::tst_forcedimension

#include "tst_forcedimension.moc"
