// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Measuring the part, the history and the layout of the window: by mouse and keys.
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QDockWidget>
#include <QUndoView>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_measure {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

/// Clicks where a place of the setup appears.
void clickAt(WindowDriver& driver, const glm::dvec3& place) {
    auto& viewport = *driver.visible<Viewport>("viewport");
    QTest::mouseClick(&viewport, Qt::LeftButton, Qt::NoModifier, viewport.project(place).toPoint());
}

bool measured(WindowDriver& driver) {
    return driver.waitFor([&] { return workbenchOf(driver).measure.measure() != nullptr; });
}

} // namespace

class TestWindowMeasure : public QObject {
    Q_OBJECT
private slots:
    /// The block of 40 x 30 x 20 mm: its thickness, then how its sides lie to each other.
    void theBlockIsMeasured() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box box = workbenchOf(driver).setup.part()->box();
        driver.key(Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(driver.message().contains("Click a place"));
        clickAt(driver, {box.centre().x + 4.0, box.centre().y + 3.0, box.high.z});
        QVERIFY(measured(driver));
        QTRY_VERIFY2(driver.message().contains("Wall thickness 20.000"), qPrintable(driver.message()));
        driver.shoot("measure-1-face");
        // Isometric: the sides towards +X and −Y are seen.
        clickAt(driver, {box.high.x, box.centre().y, box.centre().z});
        QVERIFY(driver.waitFor([&] {
            const auto measure = workbenchOf(driver).measure.measure();
            return measure && measure->pair;
        }));
        QTRY_VERIFY2(driver.message().contains(QStringLiteral("Angle 90.000°")), qPrintable(driver.message()));
        driver.shoot("measure-2-pair");
        // A third click begins anew; Esc ends it, and the view is as before.
        clickAt(driver, {box.high.x, box.centre().y, box.centre().z});
        QVERIFY(driver.waitFor([&] {
            const auto measure = workbenchOf(driver).measure.measure();
            return measure && !measure->pair;
        }));
        QTRY_VERIFY2(driver.message().contains("Wall thickness 40.000"), qPrintable(driver.message()));
        driver.key(Qt::Key_Escape);
        QTRY_VERIFY(workbenchOf(driver).measure.measure() == nullptr);
        QTRY_VERIFY(!menuAction(driver, "measureAction")->isChecked());
    }

    /// Milling takes the pointer: measuring is over then, and the drag mills.
    void millingEndsIt() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        driver.key(Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(menuAction(driver, "measureAction")->isChecked());
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}));
        QTRY_VERIFY(!menuAction(driver, "measureAction")->isChecked());
        QCOMPARE(workbenchOf(driver).mill.takes().size(), std::size_t{1});
    }

    /// The history names what was done, and a click goes back to it.
    void theHistoryLeadsBack() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        driver.key(Qt::Key_H, Qt::ControlModifier);
        auto* history = driver.visible<QUndoView>("history");
        QVERIFY(history);
        const double before = workbenchOf(driver).mill.allowance();
        workbenchOf(driver).mill.setAllowance(0.4);
        workbenchOf(driver).tool.choose("flat-10");
        QVERIFY(driver.settle());
        const int entries = history->model()->rowCount();
        QVERIFY(entries >= 3);
        driver.shoot("history");
        const auto click = [&](int row) {
            const QRect place = history->visualRect(history->model()->index(row, 0));
            QTest::mouseClick(history->viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
        };
        click(entries - 3);
        QTRY_COMPARE(workbenchOf(driver).mill.allowance(), before);
        QVERIFY(workbenchOf(driver).tool.current().id != "flat-10");
        click(entries - 1);
        QTRY_COMPARE(workbenchOf(driver).mill.allowance(), 0.4);
        QCOMPARE(workbenchOf(driver).tool.current().id, std::string("flat-10"));
        driver.key(Qt::Key_H, Qt::ControlModifier);
        QVERIFY(!history->isVisible());
    }

    /// Docks that were moved come back to where they were at first; so does the panel.
    void theLayoutIsReset() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        driver.key(Qt::Key_H, Qt::ControlModifier);
        auto* dock = driver.window().findChild<QDockWidget*>("timelineDock");
        QVERIFY(dock && dock->isVisible());
        dock->setFloating(true);
        QVERIFY(dock->isFloating());
        driver.key(Qt::Key_F9, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!dock->isFloating() && dock->isVisible());
        QVERIFY(driver.visible<QUndoView>("history") == nullptr);
    }
};

BURIN_TEST(TestWindowMeasure, QApplication)

} // namespace burin::tst_window_measure

#include "tst_window_measure.moc"
