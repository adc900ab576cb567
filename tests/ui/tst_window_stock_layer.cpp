// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Shank and holder kept away from the stock: switched by key while milling, its distance set with the devices, both
// kept.
#include "core/haptics/trace/session_trace.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/preferences.h"
#include "ui/window/session_labels.h"

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QPushButton>
#include <QtTest>

namespace burin::tst_window_stock_layer {

using namespace burin::testing;
using LayerState = BoundaryLayers::State;

class TestWindowStockLayer : public QObject {
    Q_OBJECT

    static void toggle(WindowDriver& driver) { driver.key(Qt::Key_K, Qt::ControlModifier | Qt::AltModifier); }
    static bool becomes(WindowDriver& driver, LayerState wanted) {
        const SessionRunner& session = driver.window().workbench().session;
        return driver.waitFor([&] { return session.state().stock && session.state().stock->state == wanted; });
    }

private slots:
    void itIsSwitchedByKeyAndKept() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QAction* action = menuAction(driver, QStringLiteral("keepFromStockAction"));
        QVERIFY(action != nullptr && action->isCheckable() && !action->isChecked());
        // Each session of mill mode is recorded as a trace of its own.
        const QString trace = driver.folder().filePath("stock-layer-trace.csv");
        const QString second = driver.folder().filePath("stock-layer-trace-2.csv");
        QAction* recordTrace = menuAction(driver, QStringLiteral("recordTraceAction"));
        chooseFile(driver, trace);
        driver.key(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(driver.waitFor([&] { return recordTrace->isChecked(); }, 5000));
        QVERIFY(driver.step(JobStep::mill) && driver.clickOn("millButton"));
        QVERIFY(driver.waitFor([&] { return driver.window().workbench().mill.active(); }));
        QVERIFY(becomes(driver, LayerState::off));
        toggle(driver); // over the stock, where the shank is clear of it
        QVERIFY(becomes(driver, LayerState::inForce));
        QVERIFY(action->isChecked() && UserSettings().stockLayer().on);
        driver.shoot("stock-layer-1-on");

        // What holds the tool is said.
        Workbench& workbench = driver.window().workbench();
        SessionState held = workbench.session.state();
        held.sample.flags |= sampleOnObstacle;
        held.stock->holds = true;
        QVERIFY(hintSentence(held, *workbench.workpiece.bounds(), nullptr, 0).contains("distance from the stock"));

        // Another distance, typed into the dialog of the devices, restarts milling with it.
        bool done = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.objectName(), QString("deviceDialog"));
            auto* field = dialog.findChild<QWidget*>("stockDistance");
            QApplication::setActiveWindow(&dialog); // only then a field has the focus that it loses again
            field->setFocus();
            QTRY_VERIFY(field->hasFocus());
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(field, "2.5");
            QTest::keyClick(field, Qt::Key_Tab);
            driver.shoot("stock-layer-2-distance");
            done = true;
            QTest::mouseClick(dialog.findChild<QPushButton*>("closeDevicesButton"), Qt::LeftButton);
        });
        driver.key(Qt::Key_Y, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return done; }));
        QCOMPARE(UserSettings().stockLayer().distance, 2.5);
        QCOMPARE(workbench.mill.stockLayer().distance, 2.5);
        QVERIFY(driver.waitFor([&] { return workbench.mill.active() && workbench.session.running(); }, 10'000));
        QVERIFY(becomes(driver, LayerState::inForce));
        QVERIFY(QFile::exists(trace) && !QFile::exists(second));
        toggle(driver);
        QVERIFY(becomes(driver, LayerState::off));
        toggle(driver);
        driver.key(Qt::Key_Escape);
        QVERIFY(driver.settle());
        QVERIFY(driver.waitFor([&] { return QFile::exists(second); }, 5000));
        driver.shoot("stock-layer-3-trace");
        for (const auto& [file, distance] : {std::pair{trace, 1.0}, std::pair{second, 2.5}}) {
            const auto session = readSessionTrace(file.toStdString());
            QVERIFY(session && session->began && session->readings.size() > 10);
            QCOMPARE(session->began->stock.distance, distance);
            QCOMPARE(session->began->tool, workbench.workpiece.milling()->tool.id);
            QCOMPARE(session->began->layers.size(), workbench.workpiece.bounds()->layers().size());
        }
        // A distance that is set while mill mode is being entered counts as well, by a session of its own.
        const QString fourth = driver.folder().filePath("stock-layer-trace-4.csv");
        workbench.mill.enter();
        workbench.mill.setStockLayer({3.0, true});
        const QString third = driver.folder().filePath("stock-layer-trace-3.csv");
        QVERIFY(driver.waitFor([&] { return QFile::exists(third) && workbench.mill.active(); }, 10'000));
        QVERIFY(becomes(driver, LayerState::inForce));
        driver.key(Qt::Key_Escape);
        QVERIFY(driver.waitFor([&] { return QFile::exists(fourth); }, 5000));
        const auto adopted = readSessionTrace(fourth.toStdString());
        QVERIFY(adopted && adopted->began);
        QCOMPARE(adopted->began->stock.distance, 3.0);
        workbench.mill.setStockLayer({2.5, true});
        recordTrace->trigger();
        QVERIFY(!recordTrace->isChecked() && workbench.mill.trace().empty());

        QVERIFY(saveAs(driver, driver.folder().filePath("stock-layer.burin")));
        QVERIFY(driver.restart(true)); // nobody is asked about the unsaved recording
        QVERIFY(menuAction(driver, QStringLiteral("keepFromStockAction"))->isChecked());
        QCOMPARE(driver.window().workbench().mill.stockLayer().distance, 2.5);
        UserSettings().setStockLayer({StockLayer::usualDistance, false}); // for the tests that follow
    }
};

BURIN_TEST(TestWindowStockLayer, QApplication)

} // namespace burin::tst_window_stock_layer

#include "tst_window_stock_layer.moc"
