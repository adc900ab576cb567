// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Measuring the part, the history and the layout of the window, by mouse and keys.
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QDockWidget>
#include <QFrame>
#include <QLabel>
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

    /// A slot of a 10 mm end mill: its width, and its depth by the volume that was removed; the stock left below it.
    /// What is cut at a measured point afterwards takes the measure away.
    void theMilledSlotIsMeasured() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 0.5));
        Workbench& workbench = workbenchOf(driver);
        workbench.tool.choose("flat-10");
        QVERIFY(driver.settle() && driver.waitFor([&] { return workbench.workpiece.ready(); }));
        QVERIFY(driver.step(JobStep::mill) && driver.enter("depthOfCutField", "4"));
        QVERIFY(recordLine(driver, {-10.0, 0.0}, {10.0, 0.0}) && driver.settle());
        const MillingContext& milling = *workbench.workpiece.milling();
        const double depth = removedSoFar(milling) / (20.0 * 10.0 + pi * 25.0);
        const glm::dvec3 top(glm::dvec2(milling.setup.stock.centre()), milling.setup.stock.high.z);
        driver.key(Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(driver.message().contains("Click a point on the workpiece"));
        clickAt(driver, top - glm::dvec3(0.0, 0.0, depth));
        const auto measured = [&] { return workbench.measure.workpieceMeasure(); };
        QVERIFY(driver.waitFor([&] { return measured() != nullptr; }));
        const MeasuredWorkpiece floor = measured()->from;
        QVERIFY2(floor.face.kind == MeasuredFace::Kind::plane, qPrintable(driver.message()));
        QVERIFY2(std::abs(floor.depth - depth) < 0.03 * depth + 0.02, qPrintable(QString::number(floor.depth)));
        const double partTop = workbench.setup.part()->box().high.z;
        QVERIFY(floor.fromPart && std::abs(*floor.fromPart - (top.z - floor.depth - partTop)) < 0.01);
        QVERIFY(floor.along && floor.face.thickness && floor.along->value > *floor.face.thickness); // seen obliquely
        QTRY_VERIFY2(driver.message().contains("Stock left on the part"), qPrintable(driver.message()));
        const auto* text = driver.visible<QFrame>("messageNotice")->findChild<QLabel*>();
        QTRY_VERIFY2(text->height() >= text->heightForWidth(text->width()), "a line of the message is hidden");
        driver.shoot("measure-3-workpiece");
        clickAt(driver, top + glm::dvec3(0.0, 5.0, -0.5 * floor.depth)); // the wall that is seen
        QVERIFY(driver.waitFor([&] { return measured() && measured()->to; }));
        const std::optional<MeasuredLength> width = measured()->to->opening;
        QVERIFY2(width && std::abs(width->value - 10.0) <= width->within && width->within <= 1.0,
                 qPrintable(driver.message()));
        driver.shoot("measure-4-slot");
        driver.key(Qt::Key_J, Qt::ControlModifier); // measuring the part instead
        QTRY_VERIFY(!menuAction(driver, "measureWorkpieceAction")->isChecked());
        QVERIFY(menuAction(driver, "measureAction")->isChecked() && !measured());
        driver.key(Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
        clickAt(driver, top - glm::dvec3(0.0, 0.0, depth));
        QVERIFY(driver.waitFor([&] { return measured() != nullptr; }));
        driver.key(Qt::Key_Z, Qt::ControlModifier); // the take is taken back: nothing is cut there any more
        QTRY_VERIFY(!measured());
        driver.key(Qt::Key_Escape);
        QTRY_VERIFY(!menuAction(driver, "measureWorkpieceAction")->isChecked());
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
