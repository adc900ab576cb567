// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Program zero and its work offset, by mouse and keys.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QtTest>

namespace burin::tst_window_zero {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

const Setup& setupOf(WindowDriver& driver) {
    return workbenchOf(driver).setup.setup();
}

bool near(const glm::dvec3& one, const glm::dvec3& other) {
    return glm::distance(one, other) < 1e-6;
}

void clickAt(WindowDriver& driver, const glm::dvec3& place) {
    Viewport& viewport = driver.window().viewport();
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(place).toPoint());
}

/// By the keyboard, because under software drawing the list opens slowly.
bool choose(WindowDriver& driver, const char* name, const QString& text) {
    auto* box = driver.visible<QComboBox>(name);
    if (!box) return false;
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < box->count() && box->currentText() != text; ++i) QTest::keyClick(box, Qt::Key_Down);
    return box->currentText() == text;
}

} // namespace

class TestWindowZero : public QObject {
    Q_OBJECT
private slots:
    /// A block of 40 x 30 x 20 mm in a stock of 50 x 40 x 30: zero is set on a corner of the stock, then on the part.
    void zeroIsChosenOnStockAndPart() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(driver.step(JobStep::stock));
        const Box stock = setupOf(driver).stock, part = workbenchOf(driver).setup.part()->box();
        QVERIFY(near(setupOf(driver).workOffset, {stock.centre().x, stock.centre().y, stock.high.z}));
        QTest::qWait(300);
        driver.shoot("zero-1-middle-of-the-top");
        QVERIFY(choose(driver, "zeroSideX", "left"));
        QVERIFY(choose(driver, "zeroSideY", "front"));
        QTRY_VERIFY(near(setupOf(driver).workOffset, {stock.low.x, stock.low.y, stock.high.z}));
        QVERIFY(choose(driver, "workOffset", "G55"));
        QTest::qWait(300);
        driver.shoot("zero-2-corner-of-the-stock");
        QVERIFY(choose(driver, "zeroReference", "part"));
        QTRY_VERIFY(near(setupOf(driver).workOffset, {part.low.x, part.low.y, part.high.z}));
        // The workpiece is kept, and its milling context has the new zero.
        QVERIFY(driver.settle());
        QVERIFY(workbenchOf(driver).workpiece.embedded());
        QVERIFY(near(workbenchOf(driver).workpiece.milling()->setup.workOffset, setupOf(driver).workOffset));
        QCOMPARE(workbenchOf(driver).workpiece.milling()->setup.zero.workOffset, 55);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(near(setupOf(driver).workOffset, {stock.low.x, stock.low.y, stock.high.z}));
        QCOMPARE(setupOf(driver).zero.workOffset, 55);
    }

    /// A click near a vertex of the part picks it; Esc ends picking; a click beside the part picks the stock.
    void zeroIsPickedInTheView() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box part = workbenchOf(driver).setup.part()->box(), stock = setupOf(driver).stock;
        const glm::dvec3 before = setupOf(driver).workOffset;
        driver.window().viewport().setStandardView(StandardView::top);
        QTest::qWait(500);
        driver.key(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(driver.visible("zeroPickNotice") != nullptr);
        driver.shoot("zero-3-pick");
        driver.key(Qt::Key_Escape);
        QTRY_VERIFY(driver.visible("zeroPickNotice") == nullptr);
        QVERIFY(near(setupOf(driver).workOffset, before));

        driver.key(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(driver.visible("zeroPickNotice") != nullptr);
        const glm::dvec3 corner(part.high.x, part.high.y, part.high.z);
        clickAt(driver, corner - glm::dvec3(1.0, 0.5, 0.0));
        QTRY_VERIFY(near(setupOf(driver).workOffset, corner));
        QTRY_VERIFY(driver.visible("zeroPickNotice") == nullptr);
        QTest::qWait(300);
        driver.shoot("zero-4-vertex-of-the-part");

        QVERIFY(driver.clickOn("pickZeroButton"));
        QTRY_VERIFY(driver.visible("zeroPickNotice") != nullptr);
        clickAt(driver, stock.low + glm::dvec3(1.0, 1.0, stock.size().z));
        QTRY_VERIFY(near(setupOf(driver).workOffset, {stock.low.x, stock.low.y, stock.high.z}));
        QCOMPARE(setupOf(driver).zero.on, ZeroReference::stock);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(near(setupOf(driver).workOffset, corner));
    }

    /// A recording is kept: only the program follows the new zero, and says so in its header.
    BURIN_ONLY_IN_LONG_RUNS void zeroMayChangeBehindARecording() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
        QVERIFY(newPath(driver));
        const double removed = removedSoFar(*workbenchOf(driver).workpiece.milling());
        QVERIFY(driver.step(JobStep::stock));
        QVERIFY(choose(driver, "workOffset", "G59.1"));
        QVERIFY(choose(driver, "zeroSideZ", "bottom"));
        QVERIFY(driver.settle());
        QCOMPARE(removedSoFar(*workbenchOf(driver).workpiece.milling()), removed);
        QVERIFY(postProgram(driver));
        const std::string& text = workbenchOf(driver).program.program()->text;
        QVERIFY2(text.find("\nG59.1 ") != std::string::npos, text.substr(0, 900).c_str());
        QVERIFY(text.find("Work offset: G59.1") != std::string::npos);
        driver.shoot("zero-5-program");
        // The zero is restored after a restart.
        QVERIFY(saveAs(driver, driver.folder().filePath("zero.burin")));
        QVERIFY(driver.restart());
        drop(driver.window(), driver.folder().filePath("zero.burin"));
        QTRY_COMPARE(setupOf(driver).zero.workOffset, 591);
        QVERIFY(std::abs(setupOf(driver).workOffset.z - setupOf(driver).stock.low.z) < 1e-9);
    }

    /// With the stylus that the mouse leads, three sides of the stock are touched with a ball: zero is its corner.
    /// Before there is contact nothing is set. A recording ends the stop.
    void theCornerOfTheStockIsTouchedOff() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(driver.step(JobStep::mill));
        driver.key(Qt::Key_M);
        QTRY_VERIFY(workbenchOf(driver).session.running());
        const Box stock = setupOf(driver).stock;
        const glm::dvec3 before = setupOf(driver).workOffset, middle = stock.centre();
        QTRY_VERIFY(menuAction(driver, "holdAtStockAction")->isEnabled());
        driver.key(Qt::Key_U, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(workbenchOf(driver).surroundings.stockHolds());
        QVERIFY(menuAction(driver, "holdAtStockAction")->isChecked());
        // A new zero ends mill mode for a moment, and with it the stylus.
        const auto lead = [&](const glm::dvec3& tip) {
            const MillController& mill = workbenchOf(driver).mill;
            for (int attempt = 0; attempt < 5; ++attempt) {
                if (!driver.settle() || !driver.waitFor([&] { return mill.active() && mill.stylus() != nullptr; }))
                    return false;
                SimulatedStylus* const stylus = mill.stylus();
                StylusTarget target;
                target.tip = tip;
                const auto there = [&] { return glm::distance(stylus->tip(), tip) < 0.01; };
                if (stylus->request(target) && driver.waitFor([&] { return mill.stylus() != stylus || there(); }) &&
                    mill.stylus() == stylus)
                    return true;
            }
            return false;
        };
        const auto touch = [&] { driver.key(Qt::Key_O, Qt::ControlModifier | Qt::AltModifier); };
        const auto held = [&] {
            const auto news = workbenchOf(driver).surroundings.stockNews();
            return news && news->holds;
        };

        QVERIFY(lead({stock.low.x - 15.0, middle.y, middle.z}));
        touch();
        QTRY_VERIFY2(driver.message().contains("touches nothing"), qPrintable(driver.message()));
        QVERIFY(near(setupOf(driver).workOffset, before));
        QVERIFY(lead({stock.low.x + 1.0, middle.y, middle.z})); // a hand 4 mm beyond the contact: the radius is 3 mm
        QTRY_VERIFY(held());
        driver.shoot("zero-6-stock-is-touched");
        touch();
        QTRY_VERIFY(near(setupOf(driver).workOffset, {stock.low.x, before.y, before.z}));

        QVERIFY(lead({stock.low.x - 15.0, stock.high.y + 15.0, middle.z}));
        QVERIFY(lead({middle.x, stock.high.y + 15.0, middle.z}));
        QVERIFY(lead({middle.x, stock.high.y - 1.0, middle.z}));
        QTRY_VERIFY(held());
        touch();
        QTRY_VERIFY(near(setupOf(driver).workOffset, {stock.low.x, stock.high.y, before.z}));

        QVERIFY(lead({middle.x, stock.high.y + 15.0, middle.z}));
        QVERIFY(lead({middle.x, middle.y, stock.high.z + 15.0}));
        QVERIFY(lead({middle.x, middle.y, stock.high.z - 1.0}));
        QTRY_VERIFY(held());
        touch();
        const glm::dvec3 corner(stock.low.x, stock.high.y, stock.high.z);
        QTRY_VERIFY(near(setupOf(driver).workOffset, corner));
        QCOMPARE(setupOf(driver).zero.on, ZeroReference::point);
        QVERIFY(lead({middle.x, middle.y, stock.high.z + 15.0}));
        driver.shoot("zero-7-corner-of-the-stock-touched");
        workbenchOf(driver).mill.startRecording();
        QTRY_VERIFY(workbenchOf(driver).mill.recording());
        QTRY_VERIFY(!workbenchOf(driver).surroundings.stockHolds());
        QVERIFY(!menuAction(driver, "holdAtStockAction")->isChecked());
    }

    /// Where the tool hangs free there is nothing to touch off.
    void aToolThatTouchesNothingSetsNoZero() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(driver.step(JobStep::mill));
        driver.key(Qt::Key_M);
        QTRY_VERIFY(workbenchOf(driver).session.running());
        const glm::dvec3 before = setupOf(driver).workOffset;
        QTRY_VERIFY(menuAction(driver, "touchZeroAction")->isEnabled());
        menuAction(driver, "touchZeroAction")->trigger();
        QTRY_VERIFY2(driver.message().contains("touches nothing"), qPrintable(driver.message()));
        QVERIFY(near(setupOf(driver).workOffset, before));
    }
};

BURIN_TEST(TestWindowZero, QApplication)

} // namespace burin::tst_window_zero

#include "tst_window_zero.moc"
