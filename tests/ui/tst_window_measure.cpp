// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Measuring the part, the history and the layout of the window, by mouse and keys.
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

/// Clicks where a point of the setup frame appears.
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
    /// The block of 40 x 30 x 20 mm: its thickness, then the angle between two of its sides.
    void theBlockIsMeasured() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box box = workbenchOf(driver).setup.part()->box();
        driver.key(Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(driver.message().contains("Click a point"));
        clickAt(driver, {box.centre().x + 4.0, box.centre().y + 3.0, box.high.z});
        QVERIFY(measured(driver));
        QTRY_VERIFY2(driver.message().contains("Wall thickness 20.000"), qPrintable(driver.message()));
        driver.shoot("measure-1-face");
        // In the isometric view the sides facing +X and −Y are visible.
        clickAt(driver, {box.high.x, box.centre().y, box.centre().z});
        QVERIFY(driver.waitFor([&] {
            const auto measure = workbenchOf(driver).measure.measure();
            return measure && measure->pair;
        }));
        QTRY_VERIFY2(driver.message().contains(QStringLiteral("Angle 90.000°")), qPrintable(driver.message()));
        driver.shoot("measure-2-pair");
        // A third click starts a new measurement; Esc ends it and restores the view.
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

    /// Milling takes over the pointer: measuring ends, and the drag mills.
    void millingEndsIt() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        driver.key(Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(menuAction(driver, "measureAction")->isChecked());
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}));
        QTRY_VERIFY(!menuAction(driver, "measureAction")->isChecked());
        QCOMPARE(workbenchOf(driver).mill.takes().size(), std::size_t{1});
    }

    /// The history names each step, and a click goes back to it.
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

    /// If tree, section and path need room at once, nothing overlaps, and what was hidden to save room reappears.
    void theBarBelowTheViewMakesDo() {
        WindowDriver driver(QSize(1280, 800));
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}));
        QVERIFY(newPath(driver));
        auto* bar = driver.window().findChild<QWidget*>("viewBar");
        auto* colours = driver.window().findChild<QWidget*>("pathColour");
        QVERIFY(bar && driver.waitFor([&] { return colours->isVisible(); }));
        const auto overlaps = [&] {
            std::vector<QRect> places;
            for (QWidget* widget : bar->findChildren<QWidget*>()) {
                if (!widget->isVisible() || widget->layout() != nullptr || widget->parentWidget() == nullptr) continue;
                if (widget->parentWidget() != bar && widget->parentWidget()->parentWidget() != bar) continue;
                const QRect place(widget->mapTo(bar, QPoint(0, 0)), widget->size());
                if (!bar->rect().contains(place)) return true;
                for (const QRect& other : places)
                    if (other.intersects(place)) return true;
                places.push_back(place);
            }
            return places.size() < 3;
        };
        QVERIFY(!overlaps());
        driver.key(Qt::Key_F10, Qt::ControlModifier);
        driver.key(Qt::Key_S);
        QVERIFY(driver.settle());
        QTRY_VERIFY(!overlaps());
        driver.shoot("view-bar-narrow");
        driver.key(Qt::Key_F10, Qt::ControlModifier);
        driver.window().resize(1024, 700);
        QTRY_VERIFY(!overlaps());
        driver.shoot("view-bar-narrowest");
        driver.window().resize(1600, 900);
        QTRY_VERIFY(!overlaps() && colours->isVisible());
    }

    /// Docks that were moved return to their initial positions; so does the panel.
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
