// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The axes and buttons of a 3D mouse, whose daemon is a stand-in: assigned, calibrated, and milled with.
#include "core/device/axis_map.h"
#include "tests/plugins/spacenav_daemon.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/meter_bar.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_device_axes {

using namespace burin::testing;

class TestWindowDeviceAxes : public QObject {
    Q_OBJECT

private slots:
    void axesAreAssignedAndCalibrated();
    void theAssignmentIsMilledWith();
};

namespace {

constexpr const char* mouseId = "spacenav:daemon";

bool chooseIn(QWidget& dialog, const char* name, int index) {
    auto* choice = dialog.findChild<QComboBox*>(QLatin1String(name));
    if (choice == nullptr || !choice->isEnabled()) return false;
    choice->setCurrentIndex(index);
    emit choice->activated(index);
    return true;
}

void pressIn(QWidget& dialog, const char* name) {
    QTest::mouseClick(dialog.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
}

/// Opens the dialog of the 3D mouse's axes, from the device manager by mouse, acts on it, and closes both.
void withAxes(WindowDriver& driver, test::SpacenavDaemon& daemon, const std::function<void(QWidget&)>& act) {
    bool done = false;
    driver.whenDialogStands([&](QWidget& devices) {
        auto* list = devices.findChild<RowList*>("deviceList");
        int row = -1;
        for (std::size_t i = 0; i < list->rows().size(); ++i)
            if (list->rows()[i].title.contains("3D mouse")) row = static_cast<int>(i);
        QVERIFY(row > 0);
        auto* axes = devices.findChild<QPushButton*>("deviceAxesButton");
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QVERIFY(!axes->isEnabled()); // the mouse has none
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
        QVERIFY(axes->isEnabled());
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.objectName(), QString("axisDialog"));
            daemon.accept();
            QTRY_VERIFY(dialog.findChild<QComboBox*>("axisMotion1") != nullptr);
            QTRY_VERIFY(dialog.findChild<QPushButton*>("calibrateAxesButton")->isEnabled());
            act(dialog);
        });
        QTest::mouseClick(axes, Qt::LeftButton); // returns when the dialog is closed
        done = true;
        pressIn(devices, "closeDevicesButton");
    });
    driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return done; }, 60000));
}

} // namespace

void TestWindowDeviceAxes::axesAreAssignedAndCalibrated() {
    QTemporaryDir folder;
    test::SpacenavDaemon daemon(folder.filePath("spnav.sock"));
    qputenv("SPNAV_SOCKET", folder.filePath("spnav.sock").toUtf8());
    WindowDriver driver;
    QVERIFY(driver.waitFor([&] { return driver.window().workbench().styluses.choices().size() > 2; }));
    withAxes(driver, daemon, [&](QWidget& dialog) {
        // The bars are live: 80 % to the right.
        const auto* bar = dialog.findChild<MeterBar*>("axisBar1");
        daemon.send({0, 400, 0, 0, 0, 0, 0, 16});
        QTRY_VERIFY(std::abs(bar->share() - 0.9) < 0.01);
        daemon.send({0, 0, 0, 0, 0, 0, 0, 16});
        daemon.send({1, 2});
        QTRY_VERIFY(dialog.findChild<QLabel*>("axisButton3")->text().startsWith(QString::fromUtf8("●")));
        daemon.send({2, 2});
        const auto* motion = dialog.findChild<QComboBox*>("axisMotion1");
        QCOMPARE(motion->currentIndex(), 1);         // X
        QVERIFY(chooseIn(dialog, "axisMotion1", 3)); // Z
        QTest::mouseClick(dialog.findChild<QCheckBox*>("axisReversed1"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(dialog.findChild<QCheckBox*>("axisReversed1")->isChecked());
        pressIn(dialog, "undoAxesButton");
        pressIn(dialog, "undoAxesButton");
        QCOMPARE(motion->currentIndex(), 1);
        QVERIFY(!dialog.findChild<QPushButton*>("undoAxesButton")->isEnabled());
        QVERIFY(chooseIn(dialog, "axisMotion1", 3));
        // No button mills: that is said, and nothing is kept.
        QVERIFY(chooseIn(dialog, "buttonAction1", 3));
        pressIn(dialog, "keepAxesButton");
        QTRY_VERIFY(dialog.findChild<Notice*>("axisNotice")->sentence().contains("mills"));
        QVERIFY(chooseIn(dialog, "buttonAction2", 1));
        QVERIFY(chooseIn(dialog, "buttonAction1", 5)); // clutch
        auto* calibrate = dialog.findChild<QPushButton*>("calibrateAxesButton");
        QTest::mouseClick(calibrate, Qt::LeftButton);
        QTRY_VERIFY(!calibrate->isEnabled()); // two seconds at rest
        driver.shoot("axes-1-rest");
        QTRY_COMPARE_WITH_TIMEOUT(calibrate->text(), QString("Finish"), 30000);
        for (const int x : {300, 0, -300, 0}) {
            daemon.send({0, x, 0, 0, 0, 0, 0, 16});
            QTest::qWait(60);
        }
        QTest::mouseClick(calibrate, Qt::LeftButton);
        const auto* range = dialog.findChild<QLabel*>("axisRange1");
        QTRY_COMPARE(range->text(), QString::fromUtf8("-60 to 60 %, rest 0 %"));
        daemon.send({0, 150, 0, 0, 0, 0, 0, 16}); // now half of its range
        QTRY_VERIFY(std::abs(bar->share() - 0.75) < 0.01);
        daemon.send({0, 0, 0, 0, 0, 0, 0, 16});
        driver.shoot("axes-2-calibrated");
        pressIn(dialog, "keepAxesButton");
    });
    const std::string kept = UserSettings().axisMap(mouseId);
    QVERIFY(kept.find("\"motion\":\"z\"") != std::string::npos && kept.find("\"clutch\"") != std::string::npos);
    withAxes(driver, daemon, [&](QWidget& dialog) {
        QCOMPARE(dialog.findChild<QComboBox*>("axisMotion1")->currentIndex(), 3); // as it was kept
        pressIn(dialog, "usualAxesButton");
        QCOMPARE(dialog.findChild<QComboBox*>("axisMotion1")->currentIndex(), 1);
        pressIn(dialog, "cancelAxesButton");
    });
    QCOMPARE(UserSettings().axisMap(mouseId), kept); // cancelled
    withAxes(driver, daemon, [&](QWidget& dialog) {
        pressIn(dialog, "usualAxesButton");
        pressIn(dialog, "keepAxesButton");
    });
    QVERIFY(UserSettings().axisMap(mouseId).empty());
}

void TestWindowDeviceAxes::theAssignmentIsMilledWith() {
    QTemporaryDir folder;
    test::SpacenavDaemon daemon(folder.filePath("spnav.sock"));
    qputenv("SPNAV_SOCKET", folder.filePath("spnav.sock").toUtf8());
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(driver.waitFor([&] { return workbench.styluses.choices().size() > 2; }));
    withAxes(driver, daemon, [&](QWidget& dialog) {
        QVERIFY(chooseIn(dialog, "axisMotion1", 3));   // right: up
        QVERIFY(chooseIn(dialog, "axisMotion3", 0));   // down: nothing
        QVERIFY(chooseIn(dialog, "buttonAction1", 5)); // clutch
        QVERIFY(chooseIn(dialog, "buttonAction2", 1)); // mill
        QVERIFY(chooseIn(dialog, "buttonAction3", 2)); // lift
        pressIn(dialog, "keepAxesButton");
    });
    QVERIFY(makeReady(driver, 1.0));
    const auto& choices = workbench.styluses.choices();
    const auto rate = std::ranges::find_if(
        choices, [](const StylusController::Choice& choice) { return choice.id == mouseId && choice.mode == "rate"; });
    QVERIFY(rate != choices.end());
    workbench.styluses.choose(static_cast<std::size_t>(rate - choices.begin()));
    QVERIFY(driver.step(JobStep::mill));
    driver.key(Qt::Key_M);
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    daemon.accept();
    const auto tip = [&] { return workbench.session.state().sample.stylusTip; };
    QVERIFY(driver.waitFor([&] { return workbench.session.state().sample.time > 0.1; }));
    const glm::dvec3 before = tip();
    daemon.send({0, 400, 0, 0, 0, 0, 0, 16}); // pushed to the right
    QVERIFY(driver.waitFor([&] { return tip().z > before.z + 5.0; }));
    QVERIFY(std::abs(tip().x - before.x) < 1e-6);
    daemon.send({0, 0, -400, 0, 0, 0, 0, 16}); // pressed down
    QTest::qWait(200);
    const double height = tip().z;
    QTest::qWait(200);
    QVERIFY(std::abs(tip().z - height) < 1e-6);
    daemon.send({0, 0, 0, 0, 0, 0, 0, 16});
    daemon.send({1, 0}); // the first button
    QVERIFY(driver.waitFor([&] { return workbench.hand.clutched(); }));
    daemon.send({2, 0});
    QTest::qWait(100);
    daemon.send({1, 0}); // again
    QVERIFY(driver.waitFor([&] { return !workbench.hand.clutched(); }));
    daemon.send({2, 0});
    QVERIFY(!workbench.mill.recording()); // it did not mill
    daemon.send({1, 1});                  // the second one mills
    QVERIFY(driver.waitFor([&] { return (workbench.session.state().sample.buttons & 1U) != 0; }));
    QVERIFY(driver.waitFor([&] { return workbench.mill.recording(); }));
    daemon.send({1, 2}); // the third one lifts, and stops the spindle
    const double low = tip().z;
    QVERIFY(driver.waitFor([&] { return tip().z > low + 3.0; }));
    QCOMPARE(workbench.session.state().sample.buttons & 1U, 0U);
    daemon.send({2, 2});
    daemon.send({2, 1});
    driver.key(Qt::Key_M);
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
}

BURIN_TEST(TestWindowDeviceAxes, QApplication)

} // namespace burin::tst_window_device_axes

#include "tst_window_device_axes.moc"
