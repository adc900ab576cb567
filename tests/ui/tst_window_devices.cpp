// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The device dialog, with a Touch whose library is a stand-in for the maker's.
#include "tests/places.h"
#include "tests/plugins/spacenav_daemon.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"
#include "ui/scene/camera_view.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_devices {

using namespace burin::testing;

class TestWindowDevices : public QObject {
    Q_OBJECT
    QTemporaryDir home_;

    static int rowOf(const RowList& list, const QString& title) {
        for (std::size_t i = 0; i < list.rows().size(); ++i)
            if (list.rows()[i].title.contains(title)) return static_cast<int>(i);
        return -1;
    }
    static void clickRow(RowList& list, int row) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(row)).center());
    }
    static QString text(QWidget& dialog, const char* name) { return dialog.findChild<QLabel*>(name)->text(); }

private slots:
    void initTestCase() {
        QDir().mkpath(home_.filePath("config"));
        QFile file(home_.filePath("config/Default Device.config"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        qputenv("GTDD_HOME", home_.path().toUtf8());
        qputenv("OH_SDK_BASE", BURIN_BUILD_DIRECTORY "/stand-ins/openhaptics");
        qputenv("BURIN_STAND_IN_TOUCH", "1");
    }

    void aDeviceIsTestedAndChosen() {
        WindowDriver driver;
        StylusController& styluses = driver.window().workbench().styluses;
        QVERIFY(driver.waitFor([&] { return styluses.choices().size() > 1; }));
        bool done = false;
        GainLimits kept;
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.objectName(), QString("deviceDialog"));
            auto* list = dialog.findChild<RowList*>("deviceList");
            // The reason why the other devices are missing is shown, with the folders that were searched.
            QTRY_VERIFY(rowOf(*list, "Force Dimension") > 0);
            const ListRow& missing = list->rows()[static_cast<std::size_t>(rowOf(*list, "Force Dimension"))];
            QVERIFY(missing.detail.contains("libdrd.so") && missing.detail.contains("/usr/lib"));
            auto* test = dialog.findChild<QPushButton*>("testDeviceButton");
            QVERIFY(!test->isEnabled()); // the mouse cannot be tested
            clickRow(*list, rowOf(*list, "Default Device"));
            QVERIFY(test->isEnabled());
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_VERIFY(text(dialog, "deviceLimits").contains("3.3 N"));
            QTRY_VERIFY_WITH_TIMEOUT(text(dialog, "deviceFigures").contains("Buttons pressed: 1"), 20'000);
            QTest::qWait(1300); // one turn of the circle
            driver.shoot("devices-1-test");
            QVERIFY(text(dialog, "deviceFigures").contains("Maximum force commanded: 0.00 N"));
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_COMPARE(test->text(), QString("Test"));
            // Gains follow from what was measured. One button uses them, another one takes that back, and again.
            const std::string id = "openhaptics:Default Device";
            auto* useGains = dialog.findChild<QPushButton*>("useGainsButton");
            auto* previousGains = dialog.findChild<QPushButton*>("previousGainsButton");
            QTRY_VERIFY(text(dialog, "deviceGains").contains("Suggested stiffness: 0."));
            QVERIFY(useGains->isEnabled() && !previousGains->isEnabled());
            QTest::mouseClick(useGains, Qt::LeftButton);
            kept = UserSettings().gains(id).now;
            QVERIFY(kept.stiffness < GainLimits::none && kept.damping < GainLimits::none);
            QVERIFY(!useGains->isEnabled() && text(dialog, "deviceGains").contains("In use: stiffness up to"));
            driver.shoot("devices-1-gains");
            QTest::mouseClick(previousGains, Qt::LeftButton);
            QCOMPARE(UserSettings().gains(id).now, GainLimits{});
            QTest::mouseClick(previousGains, Qt::LeftButton);
            QCOMPARE(UserSettings().gains(id).now, kept);
            // The motors exert only a requested force, and only while the button is held, which the simulated hand
            // does.
            auto* force = dialog.findChild<QWidget*>("deviceForce");
            force->setFocus();
            QTest::keyClick(force, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(force, "0.5");
            QTest::keyClick(force, Qt::Key_Tab);
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(text(dialog, "deviceFigures").contains("Maximum force commanded: 0.50 N"), 20'000);
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_COMPARE(test->text(), QString("Test"));
            auto* share = dialog.findChild<QWidget*>("deviceShare");
            share->setFocus();
            QTest::keyClick(share, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(share, "0.5");
            QTest::keyClick(share, Qt::Key_Tab);
            // A force beyond the limit for tests is refused, not clamped.
            force->setFocus();
            QTest::keyClick(force, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(force, "2");
            QTest::keyClick(force, Qt::Key_Tab);
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_VERIFY(dialog.findChild<Notice*>("deviceNotice")->sentence().contains("0.66"));
            QTest::mouseClick(dialog.findChild<QPushButton*>("useDeviceButton"), Qt::LeftButton);
            QCOMPARE(styluses.chosenName(), QString("3D Systems: Default Device"));
            driver.shoot("devices-2-chosen");
            done = true;
            QTest::mouseClick(dialog.findChild<QPushButton*>("closeDevicesButton"), Qt::LeftButton);
        });
        driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return done; }));
        QVERIFY(driver.settle());
        // The device and its share of the cutting force are restored.
        QVERIFY(driver.restart());
        QVERIFY(driver.waitFor([&] { return !driver.window().workbench().styluses.mouse(); }));
        QCOMPARE(driver.window().workbench().styluses.chosenName(), QString("3D Systems: Default Device"));
        QCOMPARE(UserSettings().felt("openhaptics:Default Device").gain, 0.5);
        QCOMPARE(UserSettings().felt("spacenav:daemon").gain, 1.0);
        QCOMPARE(driver.window().workbench().mill.gains(), kept);
    }

    /// A 3D mouse in the other hand: the view follows its cap, and the choice is restored.
    void aDeviceMovesTheView() {
        QTemporaryDir folder;
        test::SpacenavDaemon daemon(folder.filePath("spnav.sock"));
        qputenv("SPNAV_SOCKET", folder.filePath("spnav.sock").toUtf8());
        WindowDriver driver;
        const ViewDevice& device = driver.window().workbench().viewDevice;
        StylusController& styluses = driver.window().workbench().styluses;
        QVERIFY(driver.waitFor([&] { return styluses.choices().size() > 2; }));
        bool done = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* list = dialog.findChild<RowList*>("deviceList");
            auto* moves = dialog.findChild<QPushButton*>("moveViewButton");
            clickRow(*list, 0);
            QVERIFY(!moves->isEnabled()); // the mouse does so in any case
            clickRow(*list, rowOf(*list, "3D mouse"));
            QVERIFY(moves->isEnabled());
            QTest::mouseClick(moves, Qt::LeftButton);
            QTRY_COMPARE(list->rows()[static_cast<std::size_t>(rowOf(*list, "3D mouse"))].badge,
                         QString("moves the view"));
            QTRY_VERIFY(device.connected());
            driver.shoot("devices-3-view");
            done = true;
            QTest::mouseClick(dialog.findChild<QPushButton*>("closeDevicesButton"), Qt::LeftButton);
        });
        driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return done; }));
        daemon.accept();
        Viewport& view = driver.window().viewport();
        const QPointF before = view.project(glm::dvec3(0.0));
        daemon.send({0, 500, 0, 0, 0, 0, 0, 0}); // to the right
        QVERIFY(driver.waitFor([&] { return view.project(glm::dvec3(0.0)).x() > before.x() + 50.0; }));
        daemon.send({0, 0, 0, 500, 0, 0, 0, 0}); // away
        const double distance = view.cameraView().distance;
        QVERIFY(driver.waitFor([&] { return view.cameraView().distance > 1.2 * distance; }));
        daemon.send({0, 0, 0, 0, 0, 500, 0, 0}); // counterclockwise, seen from above
        const double azimuth = view.cameraView().azimuth;
        QVERIFY(driver.waitFor([&] { return std::abs(view.cameraView().azimuth - azimuth) > 0.3; }));
        daemon.send({0, 0, 0, 0, 0, 0, 0, 0});
        QTest::qWait(500); // the cap takes a moment to spring back
        const CameraView rested = view.cameraView();
        QTest::qWait(300);
        QCOMPARE(view.cameraView().azimuth, rested.azimuth);
        QCOMPARE(view.cameraView().distance, rested.distance);
        QSignalSpy fits(&device, &ViewDevice::fitRequested);
        daemon.send({1, 0, 0, 0, 0, 0, 0, 0});
        QVERIFY(driver.waitFor([&] { return fits.count() == 1; }));
        QVERIFY(driver.restart());
        QCOMPARE(driver.window().workbench().viewDevice.chosen(), std::string("spacenav:daemon"));
        UserSettings().setViewDevice({});
    }

    /// A gamepad of a user's plugin: what it can do is shown, its vibration is tested within the ceiling, which is
    /// kept, and milling uses it.
    void aGamepadAssists() {
        const QString log = home_.filePath("pad.log");
        qputenv("BURIN_STAND_IN_PAD_LOG", log.toUtf8());
        WindowDriver driver;
        const QString plugins = qEnvironmentVariable("XDG_DATA_HOME") + "/burin/plugins";
        QVERIFY(QDir().mkpath(plugins));
        QVERIFY(QFile::link(BURIN_BUILD_DIRECTORY "/stand-ins/data/burin/plugins/devices", plugins + "/devices"));
        QVERIFY(driver.restart());
        StylusController& styluses = driver.window().workbench().styluses;
        const auto found = [&] {
            return std::ranges::any_of(styluses.choices(),
                                       [](const auto& choice) { return choice.name == "Stand-in pad"; });
        };
        QVERIFY(driver.waitFor(found));
        bool done = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* list = dialog.findChild<RowList*>("deviceList");
            clickRow(*list, rowOf(*list, "Stand-in pad"));
            auto* strength = dialog.findChild<QWidget*>("deviceAssist");
            QApplication::setActiveWindow(&dialog); // its fields learn that they are left, as under a window manager
            strength->setFocus();
            QTest::keyClick(strength, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(strength, "0.2");
            QTest::keyClick(strength, Qt::Key_Tab);
            auto* test = dialog.findChild<QPushButton*>("testDeviceButton");
            QTest::mouseClick(test, Qt::LeftButton);
            QCOMPARE(UserSettings().felt("assist_pad:pad").assist, 0.2);
            QTRY_VERIFY(text(dialog, "deviceLimits").contains("assist: vibrates"));
            QTRY_VERIFY_WITH_TIMEOUT(text(dialog, "deviceFigures").contains("Maximum strength commanded: 20 %"),
                                     20'000);
            driver.shoot("devices-4-assist");
            QTest::mouseClick(test, Qt::LeftButton);
            QTRY_COMPARE(test->text(), QString("Test"));
            QTest::mouseClick(dialog.findChild<QPushButton*>("useDeviceButton"), Qt::LeftButton);
            done = true;
            QTest::mouseClick(dialog.findChild<QPushButton*>("closeDevicesButton"), Qt::LeftButton);
        });
        driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return done; }));
        QCOMPARE(UserSettings().felt("assist_pad:pad").assist, 0.2);
        QCOMPARE(UserSettings().felt("spacenav:daemon").assist, 0.3);
        QVERIFY(QFile::remove(log));
        // The hand presses the tool into the part: the strong motor shows it.
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(driver.step(JobStep::mill));
        driver.key(Qt::Key_M);
        SessionRunner& session = driver.window().workbench().session;
        QVERIFY(driver.waitFor([&] { return session.running(); }));
        QVERIFY(driver.waitFor([&] { return (session.state().sample.flags & sampleOnBoundary) != 0; }));
        QTest::qWait(500);
        driver.shoot("devices-5-assist-milling");
        driver.key(Qt::Key_M);
        QVERIFY(driver.waitFor([&] { return QFile::exists(log); }));
        QFile file(log);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> shown = file.readAll().simplified().split(' ');
        QCOMPARE(shown.size(), 4);
        QVERIFY2(shown[0].toDouble() > 0.1 && shown[0].toDouble() <= 0.2, shown[0].constData());
        QCOMPARE(shown[3].toDouble(), 0.2);
        styluses.choose(0);
    }

    void aDialogueThatIsClosedEndsItsTest() {
        WindowDriver driver;
        StylusController& styluses = driver.window().workbench().styluses;
        QVERIFY(driver.waitFor([&] { return styluses.choices().size() > 1; }));
        bool done = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* list = dialog.findChild<RowList*>("deviceList");
            clickRow(*list, rowOf(*list, "Default Device"));
            QTest::mouseClick(dialog.findChild<QPushButton*>("testDeviceButton"), Qt::LeftButton);
            QTRY_VERIFY(text(dialog, "deviceFigures").contains("Rate"));
            done = true;
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return done; }));
        QVERIFY(driver.waitFor([&] { return driver.window().workbench().deviceTester.possible(); }));
    }

    void itIsMilledWith() {
        WindowDriver driver;
        Workbench& workbench = driver.window().workbench();
        QVERIFY(driver.waitFor([&] { return workbench.styluses.choices().size() > 1; }));
        QVERIFY(makeReady(driver, 1.0));
        if (workbench.styluses.mouse()) workbench.styluses.choose(1);
        QCOMPARE(workbench.styluses.chosenName(), QString("3D Systems: Default Device"));
        QVERIFY(driver.step(JobStep::mill));
        driver.key(Qt::Key_M);
        QVERIFY(driver.waitFor([&] { return workbench.session.running(); }));
        QVERIFY(driver.waitFor([&] { return workbench.session.health().readings > 200; }));
        QVERIFY(!workbench.deviceTester.possible()); // it is in use as the stylus
        driver.shoot("devices-3-milling");
        driver.key(Qt::Key_M);
        QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
    }
};

BURIN_TEST(TestWindowDevices, QApplication)

} // namespace burin::tst_window_devices

#include "tst_window_devices.moc"
