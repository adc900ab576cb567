// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The orientation of the part and its second side, by mouse and keys.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_setups {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

glm::dvec3 sizeOfPart(WindowDriver& driver) {
    const auto& part = workbenchOf(driver).setup.part();
    return part ? part->box().size() : glm::dvec3(0.0);
}

bool near(const glm::dvec3& one, const glm::dvec3& other) {
    return glm::distance(one, other) < 1e-6;
}

/// Clicks a point of the part in the view.
void clickAt(WindowDriver& driver, const glm::dvec3& place) {
    Viewport& viewport = driver.window().viewport();
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(place).toPoint());
}

/// Fills in the dialog of a further setup.
void addSetup(WindowDriver& driver, const QString& name, int turn, const QString& picture = {}) {
    driver.whenDialogStands([&driver, name, turn, picture](QWidget& dialog) {
        auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("setupNameField"));
        auto* turns = dialog.findChild<QComboBox*>(QStringLiteral("setupTurn"));
        if (field && turns) {
            field->selectAll();
            QTest::keyClicks(field, name);
            turns->setFocus();
            for (int i = 0; i < turn; ++i) QTest::keyClick(turns, Qt::Key_Down);
        }
        if (!picture.isEmpty()) driver.shoot(picture);
        answer(dialog, "confirmButton");
    });
    driver.key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
}

bool isIn(WindowDriver& driver, const QString& title) {
    const SetupsController& setups = workbenchOf(driver).setups;
    return setups.title(setups.used()) == title;
}

} // namespace

class TestWindowSetups : public QObject {
    Q_OBJECT
private slots:
    /// A click on the front of a block of 40 x 30 x 20 mm lays it on that face; undo lays it back.
    void aFaceIsLaidDown() {
        WindowDriver driver;
        drop(driver.window(), writeBlock(driver));
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); }));
        QVERIFY(driver.settle() && driver.step(JobStep::part));
        QVERIFY(near(sizeOfPart(driver), {40.0, 30.0, 20.0}));
        QTest::qWait(300);
        driver.shoot("setup-1-as-it-came");
        const Box box = workbenchOf(driver).setup.part()->box();
        const glm::dvec3 front(box.centre().x + 3.0, box.low.y, box.centre().z + 2.0);

        QVERIFY(driver.clickOn("faceDownButton"));
        QTRY_VERIFY(driver.visible("facePickNotice") != nullptr);
        driver.key(Qt::Key_Escape); // cancelled this time
        QTRY_VERIFY(driver.visible("facePickNotice") == nullptr);
        clickAt(driver, front);
        QTest::qWait(200);
        QVERIFY(near(sizeOfPart(driver), {40.0, 30.0, 20.0}));

        QVERIFY(driver.clickOn("faceDownButton"));
        QTRY_VERIFY(driver.visible("facePickNotice") != nullptr);
        driver.shoot("setup-2-pick-a-face");
        clickAt(driver, front);
        QTRY_VERIFY(near(sizeOfPart(driver), {40.0, 20.0, 30.0}));
        QVERIFY(near(workbenchOf(driver).setup.part()->box().centre(), box.centre()));
        // The front now faces down.
        const Placement& placement = workbenchOf(driver).setup.setup().placement;
        QVERIFY(near(placement.direction({0.0, -1.0, 0.0}), {0.0, 0.0, -1.0}));
        QTest::qWait(300);
        driver.shoot("setup-3-laid-down");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(near(sizeOfPart(driver), {40.0, 30.0, 20.0}));
        QVERIFY(isNone(workbenchOf(driver).setup.setup().placement));
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(near(sizeOfPart(driver), {40.0, 20.0, 30.0}));
    }

    /// By numbers: an angle, a position; by keys: quarter turns; a mirror image. Each is one undo step.
    void aPartIsTurnedMovedAndMirrored() {
        WindowDriver driver;
        drop(driver.window(), writeBlock(driver));
        QVERIFY(driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); }));
        QVERIFY(driver.settle() && driver.step(JobStep::part));
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(near(sizeOfPart(driver), {30.0, 40.0, 20.0}));
        QVERIFY(driver.enter("turnAngle", "90"));
        QTRY_VERIFY(near(sizeOfPart(driver), {40.0, 30.0, 20.0}));
        QVERIFY(driver.enter("turnAngle", "30"));
        const double cosine = std::cos(M_PI / 6.0), sine = 0.5;
        QTRY_VERIFY(near(sizeOfPart(driver), {40.0 * cosine + 30.0 * sine, 40.0 * sine + 30.0 * cosine, 20.0}));
        QVERIFY(driver.enter("positionX", "12.5"));
        QTRY_VERIFY2(std::abs(workbenchOf(driver).setup.part()->box().low.x - 12.5) < 1e-9,
                     qPrintable(QString::number(workbenchOf(driver).setup.part()->box().low.x, 'g', 17)));
        QTest::qWait(300);
        driver.shoot("setup-4-by-numbers");
        QVERIFY(driver.clickOn("mirrorYButton"));
        QTRY_VERIFY(mirrors(workbenchOf(driver).setup.imported()->brepPlacement));
        for (int i = 0; i < 5; ++i) driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(isNone(workbenchOf(driver).setup.setup().placement));
        QVERIFY(!mirrors(workbenchOf(driver).setup.imported()->brepPlacement));
    }

    /// The second side starts with what the first one left; each side keeps its own settings, also in the file.
    BURIN_ONLY_IN_LONG_RUNS void theSecondSideIsMilled() {
        WindowDriver driver;
        QVERIFY(makeReady(driver));
        Workbench& workbench = workbenchOf(driver);
        QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
        const double removed = removedSoFar(*workbench.workpiece.milling()),
                     volume = workbench.workpiece.milling()->workpieceVolume();
        QVERIFY(removed > 10.0);
        addSetup(driver, "Underside", 0, "setup-5-add");
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Underside") && workbench.workpiece.embedded(); }));
        QVERIFY(driver.settle());
        // The same volume, with the groove below: the top is uncut.
        const MillingContext& milling = *workbench.workpiece.milling();
        QVERIFY2(std::abs(milling.workpieceVolume() - volume) < 1e-3 * volume,
                 qPrintable(QString("%1 of %2").arg(milling.workpieceVolume()).arg(volume)));
        QVERIFY(workbench.mill.takes().empty() && removedSoFar(milling) == 0.0);
        const Box stock = milling.setup.stock;
        QVERIFY(near(stock.size(), {50.0, 40.0, 30.0}));
        driver.window().viewport().setStandardView(StandardView::bottom);
        QTest::qWait(500);
        driver.shoot("setup-6-underside-from-below");
        driver.window().viewport().setStandardView(StandardView::isometric);
        QTest::qWait(500);
        QVERIFY(recordLine(driver, {-10, 5}, {10, 5}));
        QCOMPARE(workbench.mill.takes().size(), std::size_t{1});
        const double below = removedSoFar(*workbench.workpiece.milling());
        QVERIFY(below > 10.0);
        QVERIFY(newPath(driver) && postProgram(driver));
        driver.shoot("setup-7-second-program");

        driver.key(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Setup 1") && workbench.workpiece.embedded(); }));
        QVERIFY(driver.settle());
        QVERIFY(workbench.program.program() == nullptr && workbench.path.stored() == nullptr);
        QVERIFY(std::abs(removedSoFar(*workbench.workpiece.milling()) - removed) < 1e-6);
        driver.key(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Underside") && workbench.workpiece.embedded(); }));
        QVERIFY(driver.settle() && workbench.program.program() != nullptr);

        const QString file = driver.folder().filePath("sides.burin");
        QVERIFY(saveAs(driver, file) && driver.restart());
        driver.window().openFile(file);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Underside") && workbenchOf(driver).workpiece.embedded(); }));
        QVERIFY(driver.settle());
        QVERIFY(std::abs(removedSoFar(*workbenchOf(driver).workpiece.milling()) - below) < 1e-6);
    }

    /// After a change of the first side, the second one reports it and takes its stock again.
    BURIN_ONLY_IN_LONG_RUNS void aChangedFirstSideIsTold() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        Workbench& workbench = workbenchOf(driver);
        QVERIFY(recordLine(driver, {-15, 0}, {15, 0}));
        addSetup(driver, "Underside", 1);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Underside") && workbench.workpiece.embedded(); }));
        QVERIFY(driver.settle() && !workbench.setups.stockOutOfDate());
        const double before = workbench.workpiece.milling()->workpieceVolume();
        driver.key(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Setup 1") && workbench.workpiece.embedded(); }));
        QVERIFY(driver.settle() && recordLine(driver, {-15, 8}, {15, 8}));
        const double left = workbench.workpiece.milling()->workpieceVolume();
        QVERIFY(left < before - 10.0);
        driver.key(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver.waitFor([&] { return isIn(driver, "Underside"); }));
        QVERIFY(driver.settle() && driver.step(JobStep::part));
        QTRY_VERIFY(workbench.setups.stockOutOfDate() && driver.visible("takeStockButton") != nullptr);
        driver.shoot("setup-8-out-of-date");
        QVERIFY(driver.clickOn("takeStockButton"));
        QVERIFY(driver.waitFor([&] {
            return isIn(driver, "Underside") && !workbench.setups.stockOutOfDate() && !workbench.setups.adding() &&
                   workbench.workpiece.embedded();
        }));
        QVERIFY(driver.settle());
        QVERIFY(std::abs(workbench.workpiece.milling()->workpieceVolume() - left) < 1e-3 * left);

        // An empty setup is removed; one with content stays and says why.
        QVERIFY(driver.step(JobStep::part) && driver.clickOn("removeSetupButton"));
        QVERIFY(driver.waitFor([&] { return workbench.setups.setups().size() == 1; }));
        QVERIFY(driver.settle() && isIn(driver, "Setup 1"));
    }
};

BURIN_TEST(TestWindowSetups, QApplication)

} // namespace burin::tst_window_setups

#include "tst_window_setups.moc"
