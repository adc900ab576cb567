// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/stylus_handle.h"
#include "plugins/devices/openhaptics/driver.h"
#include "plugins/devices/openhaptics/hd_description.h"
#include "plugins/devices/openhaptics/hd_faults.h"
#include "plugins/devices/openhaptics/hd_stylus.h"
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/plugins/stand_ins/hd_stand_in.h"
#include "tests/plugins/stand_ins/stand_in.h"
#include "tests/plugins/through_driver.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_openhaptics {

using namespace burin::test;
using burin::testing::HdDevice;
using burin::testing::HdStandIn;

namespace {

const QString standIns = BURIN_BUILD_DIRECTORY "/stand-ins/";

HdStandIn& hdStandIn() {
    static HdStandIn& instance =
        burin::testing::standInOf<HdStandIn>(BURIN_BUILD_DIRECTORY "/stand-ins/openhaptics/libHD.so", "burinHdStandIn");
    return instance;
}

/// Sets a position, converted from Burin's device frame to libHD's.
void moveTo(HdDevice& device, const glm::dvec3& place) {
    device.transform[12] = place.x;
    device.transform[13] = place.z;
    device.transform[14] = -place.y;
}

glm::dvec3 felt(const HdDevice& device) {
    return {device.force[0], -device.force[2], device.force[1]};
}

/// Returns a fixed answer and counts calls.
class Client final : public StylusClient {
public:
    void begins() noexcept override { ++begun; }
    Wrench tick(const StylusState& given) noexcept override {
        state = given;
        ++ticks;
        if (inTick) inTick();
        return answer;
    }
    void ends() noexcept override { ++ended; }
    StylusState state;
    Wrench answer;
    std::function<void()> inTick;
    std::atomic<int> ticks{0}, begun{0}, ended{0};
};

} // namespace

/// The driver for 3D Systems' devices, with a stand-in for libHD that complains about every call that its reference
/// forbids. No real device was available.
class TestOpenHaptics : public QObject {
    Q_OBJECT
    QTemporaryDir home_;
    std::unique_ptr<DeviceDriver> driver_;

    HdDevice& plug(const char* name = "Default Device") { return hdStandIn().devices[name] = HdDevice(); }
    std::unique_ptr<SelfPacedStylus> stylus(const char* id = "Default Device") {
        auto made = driver_->make(id, {});
        if (!made) return nullptr;
        return std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*made));
    }
    void configure(const QString& name) {
        QDir().mkpath(home_.filePath("config"));
        QFile file(home_.filePath("config/" + name + ".config"));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }

private slots:
    void init() {
        hdStandIn().reset();
        qputenv("OH_SDK_BASE", (standIns + "openhaptics").toUtf8());
        qputenv("GTDD_HOME", home_.path().toUtf8());
        qputenv("HOME", home_.filePath("nobody").toUtf8());
        configure("Default Device");
        driver_ = openhaptics::makeDriver();
    }
    void cleanup() {
        driver_.reset();
        for (const std::string& complaint : hdStandIn().complaints) qWarning("%s", complaint.c_str());
        QVERIFY(hdStandIn().complaints.empty());
        QDir(home_.filePath("config")).removeRecursively();
    }

    void devicesAreThoseThatWereSetUp() {
        configure("Left Touch");
        const auto found = driver_->find();
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].id, std::string("Default Device"));
        QCOMPARE(found[1].id, std::string("Left Touch"));
        QCOMPARE(found[1].name, std::string("3D Systems: Left Touch"));
        QCOMPARE(hdStandIn().initialisations, 0); // enumerating devices does not switch any on
        QCOMPARE(driver_->make("Right Touch", {}).error().code, ErrorCode::deviceNotFound);
        QCOMPARE(driver_->make("Left Touch", {}).error().code, ErrorCode::deviceNotFound); // not plugged in
    }

    void aLibraryThatIsNotThereIsSaidWithItsFolders() {
        QTemporaryDir empty;
        qputenv("OH_SDK_BASE", empty.path().toUtf8());
        const auto driver = openhaptics::makeDriver();
        const auto ready = driver->ready();
        QVERIFY(!ready);
        QCOMPARE(ready.error().code, ErrorCode::deviceLibraryMissing);
        QVERIFY(ready.error().detail.starts_with(empty.path().toStdString()));
        QVERIFY(ready.error().place.starts_with("libHD.so"));
        QVERIFY(driver->find().empty());
        QCOMPARE(driver->make("Default Device", {}).error().code, ErrorCode::deviceLibraryMissing);
    }

    void aLibraryThatIsNotTheOneIsSaidToo() {
        qputenv("OH_SDK_BASE", (standIns + "openhaptics-old").toUtf8());
        const auto old = openhaptics::makeDriver()->ready();
        QCOMPARE(old.error().code, ErrorCode::deviceLibraryUnfit);
        QCOMPARE(old.error().place, std::string("hdBeginFrame"));
        QTemporaryDir folder;
        QFile file(folder.filePath("libHD.so.3.4"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("not a library") > 0);
        file.close();
        qputenv("OH_SDK_BASE", folder.path().toUtf8());
        const auto text = openhaptics::makeDriver()->ready();
        QCOMPARE(text.error().code, ErrorCode::deviceLibraryUnfit);
        QCOMPARE(text.error().subject, file.fileName().toStdString());
    }

    void aDeviceSaysWhatItBears() {
        plug();
        const StylusDescription told = stylus()->description();
        QCOMPARE(told.name, std::string("Touch (Default Device)"));
        QVERIFY(told.sensed == (Freedoms{3, 3}) && told.actuated == (Freedoms{3, 0}));
        QCOMPARE(told.maximumForce.value, 3.3);
        QCOMPARE(told.continuousForce.value, 0.88);
        QCOMPARE(told.maximumStiffness.value, 500.0); // N/m
        QCOMPARE(told.maximumDamping.value, 4.0);     // N·s/m
        QCOMPARE(told.workspaceRadius.value, 35.0);
        QCOMPARE(told.rate.value, 1000.0);
        plug().stiffness = NAN;
        QCOMPARE(driver_->make("Default Device", {}).error().code, ErrorCode::deviceFault);
    }

    void posesAndForcesAreTurnedIntoOurFrame() {
        HdDevice& device = plug();
        const auto pen = stylus();
        QVERIFY(pen->open());
        Client client;
        client.answer.force = {1.0, 2.0, 3.0};
        QVERIFY(pen->start(client));
        // The pen points straight down: its own z axis, from the tip backwards, is the library's y axis.
        device.transform = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 10.0, 20.0, -30.0, 1};
        device.buttons = 2;
        device.heat = 0.5;
        hdStandIn().step();
        QVERIFY(client.state.valid);
        QCOMPARE(client.state.pose.position, glm::dvec3(10.0, 30.0, 20.0));
        QVERIFY(glm::distance(toolPose(client.state.pose).axis, glm::dvec3(0, 0, 1)) < 1e-12);
        QCOMPARE(client.state.buttons, 2U);
        QCOMPARE(client.state.motorHeat, 0.5);
        QCOMPARE(device.force, (std::array{1.0, 3.0, -2.0}));
        QCOMPARE(client.begun.load(), 1);
        // A matrix that is slightly off is corrected to a rotation.
        device.transform = {1.001, 0.002, 0, 0, 0, 0.001, -0.998, 0, 0, 1.003, 0.001, 0, 0, 0, 0, 1};
        hdStandIn().step();
        QVERIFY(std::abs(glm::length(client.state.pose.rotation) - 1.0) < 1e-12);
        device.transform[12] = NAN;
        hdStandIn().step();
        QVERIFY(!client.state.valid);
        QCOMPARE(device.force, (std::array{0.0, 0.0, 0.0}));
        hdStandIn().devices["Default Device"].transform[12] = 0.0;
    }

    void everyErrorTakesTheForceAway_data() {
        QTest::addColumn<uint>("code");
        QTest::addColumn<int>("fault");
        const auto row = [](const char* name, uint code, DeviceFault fault) {
            QTest::newRow(name) << code << static_cast<int>(fault);
        };
        row("warm motors", 0x0200, DeviceFault::overheated);
        row("too much force", 0x0201, DeviceFault::overloaded);
        row("too sudden a force", 0x0202, DeviceFault::overloaded);
        row("too fast", 0x0203, DeviceFault::tooFast);
        row("force", 0x0204, DeviceFault::overloaded);
        row("device", 0x0300, DeviceFault::mechanism);
        row("timer", 0x0304, DeviceFault::mechanism);
        row("frame", 0x0400, DeviceFault::mechanism);
        row("scheduler", 0x0500, DeviceFault::mechanism);
        row("something new", 0x0777, DeviceFault::mechanism);
    }
    void everyErrorTakesTheForceAway() {
        QFETCH(uint, code);
        QFETCH(int, fault);
        HdDevice& device = plug();
        const auto pen = stylus();
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        QVERIFY(pen->start(client));
        hdStandIn().step();
        QCOMPARE(felt(device).z, 1.0);
        QVERIFY(!pen->takeFault());
        hdStandIn().raise(code);
        hdStandIn().step(); // the tick in which it is detected
        hdStandIn().step();
        QCOMPARE(felt(device).z, 0.0);
        QVERIFY(!client.state.valid);
        const auto told = pen->takeFault();
        const Error expected = errorOf(static_cast<DeviceFault>(fault), "Touch (Default Device)");
        QVERIFY(told && told->code == expected.code && told->detail == expected.detail);
        QTest::qWait(static_cast<int>(1500.0 * openhaptics::HdStylus::calmAfter));
        hdStandIn().step();
        QVERIFY(client.state.valid);
    }

    void unpluggedItWaitsAndGoesOn() {
        HdDevice& device = plug();
        hdStandIn().byHand = false;
        const auto pen = stylus();
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        QVERIFY(pen->start(client));
        QTRY_VERIFY(client.ticks > 20);
        {
            const std::lock_guard lock(hdStandIn().mutex);
            device.plugged = false;
        }
        QTRY_VERIFY(!pen->health().connected);
        QCOMPARE(pen->takeFault()->code, ErrorCode::deviceUnplugged);
        const int before = client.ticks;
        QTRY_VERIFY(client.ticks > before + 100); // the client's own guards go on
        {
            const std::lock_guard lock(hdStandIn().mutex);
            QCOMPARE(felt(device).z, 0.0);
            device.plugged = true;
        }
        QTRY_VERIFY(pen->health().connected);
        QTRY_COMPARE(
            [&] {
                const std::lock_guard lock(hdStandIn().mutex);
                return felt(device).z;
            }(),
            1.0);
        pen->stop();
        QCOMPARE(client.begun.load(), 1);
        QCOMPARE(client.ended.load(), 1);
        QCOMPARE(felt(device).z, 0.0);
        QVERIFY(!device.forcesOn && !hdStandIn().schedulerRuns());
    }

    void aStuckTickIsCutFromOutside() {
        HdDevice& device = plug();
        hdStandIn().byHand = false;
        const auto pen = stylus();
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        std::atomic<bool> stuck{false}, reached{false};
        client.inTick = [&] {
            while (stuck) {
                reached = true;
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        };
        QVERIFY(pen->start(client));
        const auto force = [&] {
            const std::lock_guard lock(hdStandIn().mutex);
            return felt(device).z;
        };
        QTRY_COMPARE(force(), 1.0);
        stuck = true;
        QTRY_VERIFY(reached.load());
        pen->cutMotors();
        QCOMPARE(force(), 0.0);
        // The answer of the stuck tick is sent as zero; the next one is felt again.
        const int frames = device.frames;
        stuck = false;
        QTRY_VERIFY(device.frames > frames + 3);
        QTRY_COMPARE(force(), 1.0);
        pen->stop();
    }

    void anUncalibratedPenIsNotUsed() {
        HdDevice& device = plug();
        device.calibration = 0x5001;
        QVERIFY(stylus()->open());
        QCOMPARE(device.updatedWith, 4U); // inkwell
        HdDevice& second = plug();
        second.calibration = second.afterUpdate = 0x5002;
        const auto refused = stylus()->open();
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::deviceFault);
        // A device that would accept any pose as its rest pose is not reset without a request.
        HdDevice& third = plug();
        third.calibration = 0x5001;
        third.calibrationStyles = 1;
        QVERIFY(!stylus()->open());
        QCOMPARE(third.updatedWith, 0U);
    }

    void twoDevicesHaveTheirOwnForces() {
        configure("Left Touch");
        HdDevice& right = plug();
        HdDevice& left = plug("Left Touch");
        const auto first = stylus(), second = stylus("Left Touch");
        QVERIFY(first != nullptr && second != nullptr);
        Client one, two;
        one.answer.force = {1.0, 0.0, 0.0};
        two.answer.force = {0.0, 0.0, 2.0};
        QVERIFY(first->start(one) && second->start(two));
        moveTo(left, {5.0, 6.0, 7.0});
        hdStandIn().step();
        hdStandIn().step();
        QCOMPARE(felt(right), glm::dvec3(1.0, 0.0, 0.0));
        QCOMPARE(felt(left), glm::dvec3(0.0, 0.0, 2.0));
        QCOMPARE(two.state.pose.position, glm::dvec3(5.0, 6.0, 7.0));
        QVERIFY(!stylus()); // a device can have only one stylus
        // An error of one device that is detected in the other's frame is attributed to the right one.
        for (const auto& [handle, name] : hdStandIn().handles_)
            if (name == "Left Touch") hdStandIn().raise(0x0203, handle);
        hdStandIn().step();
        hdStandIn().step();
        QVERIFY(!first->takeFault() && one.state.valid);
        QVERIFY(second->takeFault() && !two.state.valid);
        QCOMPARE(felt(left), glm::dvec3(0.0));
        QCOMPARE(felt(right), glm::dvec3(1.0, 0.0, 0.0));
        first->stop(); // without another tick of the scheduler
        QCOMPARE(felt(right), glm::dvec3(0.0));
        QVERIFY(!right.forcesOn);
    }

    void torqueGoesToAWristThatHasMotors() {
        HdDevice& device = plug();
        device.outputFreedoms = 6;
        const auto pen = stylus();
        QCOMPARE(pen->description().actuated.rotations, 3);
        Client client;
        client.answer.torque = {10.0, 20.0, 30.0}; // N·mm
        QVERIFY(pen->start(client));
        hdStandIn().step();
        QCOMPARE(device.torque, (std::array{10.0, 30.0, -20.0})); // mN·m
    }

    /// A contact gives no energy to a hand through the driver, for any grip; with the mechanism of a Touch.
    void aContactGivesNoEnergy() {
        HdDevice& device = plug();
        const auto pen = stylus();
        for (const SimulatedGrip& grip : {lightGrip, middleGrip, firmGrip}) {
            HapticSettings settings;
            settings.stylus = pen->description();
            settings.rampSeconds = 0.0;
            Rig rig(settings, ballTool(), stockOnPart(0, false));
            StepClient client(rig.step);
            QVERIFY(pen->start(client));
            SimulatedMechanism mechanism;
            mechanism.mass = 0.045; // kg: 3D Systems' data sheet of the Touch, apparent at the tip
            mechanism.encoder = 0.055;
            double most = 0.0;
            const double energy = energyPerContact(grip, mechanism, [&](const glm::dvec3& reading, std::uint32_t) {
                moveTo(device, reading);
                hdStandIn().step();
                most = std::max(most, felt(device).z);
                return felt(device);
            });
            pen->stop();
            qInfo("%.4f mJ a contact, at most %.2f N", 1e3 * energy, most);
            QVERIFY2(1e3 * energy <= 0.02, qPrintable(QString::number(1e3 * energy)));
            QVERIFY(most > 0.1);
        }
    }

    void hostileReadingsStayWithinTheLimits() {
        HdDevice& device = plug();
        const auto pen = stylus();
        HapticSettings settings;
        settings.stylus = pen->description();
        settings.rampSeconds = 0.05;
        settings.felt.gain = 100.0;
        Rig rig(settings, ballTool(5.0, 12.0));
        StepClient client(rig.step);
        QVERIFY(pen->start(client));
        const int ticks = burin::testing::inLongRun(1'000'000, 100'000);
        const QString said = hostileReadings(pen->description(), settings.forceShare, ticks,
                                             [&](const glm::dvec3& reading, std::uint32_t buttons) {
                                                 moveTo(device, reading);
                                                 device.buttons = static_cast<int>(buttons & 3U);
                                                 hdStandIn().step();
                                                 return felt(device);
                                             });
        pen->stop();
        QVERIFY2(said.isEmpty(), qPrintable(said));
    }

    void aSessionComesOutOfItsTrace() {
        HdDevice& device = plug();
        hdStandIn().byHand = false;
        const auto pen = stylus();
        const QString said = sessionThroughDriver(*pen, [&](const glm::dvec3& place) {
            const std::lock_guard lock(hdStandIn().mutex);
            moveTo(device, place);
        });
        QVERIFY2(said.isEmpty(), qPrintable(said));
    }
};

BURIN_TEST(TestOpenHaptics, QCoreApplication)

} // namespace burin::tst_openhaptics

#include "tst_openhaptics.moc"
