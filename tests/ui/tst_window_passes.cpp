// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Computed passes, by mouse and keys.
#include "core/base/units.h"
#include "core/setup/setup.h"
#include "tests/long_run.h"
#include "tests/plate_with_hole.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/quantity_field.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QSpinBox>
#include <QThread>
#include <QtTest>

namespace burin::tst_window_passes {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

/// By the keyboard, because under software drawing the list opens slowly.
bool choose(QWidget& in, const char* name, int index) {
    auto* box = in.findChild<QComboBox*>(name);
    if (!box || !box->isVisible()) return false;
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < index; ++i) QTest::keyClick(box, Qt::Key_Down);
    return box->currentIndex() == index;
}

bool enter(QWidget& in, const char* name, const QString& text) {
    auto* field = in.findChild<QAbstractSpinBox*>(name);
    if (!field || !field->isVisible()) return false;
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Tab);
    return true;
}

bool press(QWidget& in, const char* name) {
    auto* button = in.findChild<QWidget*>(name);
    if (!button || !button->isEnabled()) return false;
    QTest::mouseClick(button, Qt::LeftButton);
    return true;
}

/// A plate of 40 x 30 x 8 mm with a round hole through its middle. @param diameter mm
QString writePlateWithHole(const WindowDriver& driver, double diameter) {
    const QString file = driver.folder().filePath("plate.stl");
    QFile text(file);
    if (text.open(QIODevice::WriteOnly)) text.write(stlText(test::plateWithHole({20.0, 15.0}, 8.0, 0.5 * diameter)));
    return file;
}

/// A plate of 40 x 30 x 8 mm with a round stud for M8 on its middle, 10 mm high.
QString writePlateWithStud(const WindowDriver& driver) {
    const QString file = driver.folder().filePath("stud.stl");
    QFile text(file);
    if (text.open(QIODevice::WriteOnly)) text.write(stlText(test::plateWithStud({20.0, 15.0}, 8.0, 3.188, 10.0)));
    return file;
}

/// Embeds such a plate, ready to be milled.
bool hasPlate(WindowDriver& driver, const QString& file) {
    drop(driver.window(), file);
    Workbench& workbench = workbenchOf(driver);
    return driver.waitFor([&] { return workbench.model.model() != nullptr; }) && driver.step(JobStep::stock) &&
           driver.settle() && driver.enter("voxelField", "0.5") &&
           driver.waitFor([&] { return workbench.setup.setup().voxel == 0.5; }) && driver.clickOn("embedButton") &&
           driver.waitFor([&] { return workbench.workpiece.ready(); });
}

bool hasPlateWithHole(WindowDriver& driver, double diameter) {
    return hasPlate(driver, writePlateWithHole(driver, diameter));
}

bool hasTool(WindowDriver& driver, const std::string& id) {
    workbenchOf(driver).tool.choose(id);
    return driver.waitFor([&] { return workbenchOf(driver).passes.possible(); }) && driver.settle();
}

const EvaluatedPath* evaluatedIn(WindowDriver& driver) {
    const PathController& path = workbenchOf(driver).path;
    return path.outdated() || path.busy() ? nullptr : path.evaluated().get();
}

} // namespace

class TestWindowPasses : public QObject {
    Q_OBJECT
private slots:
    /// A block of 40 x 30 x 20 mm is roughed and its outline finished, undone, redone and posted, all without a
    /// recording.
    void aBlockIsMilledWithoutARecording() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "flat-10"));
        QVERIFY(driver.step(JobStep::path));
        driver.shoot("passes-1-no-path-yet");
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.objectName(), QString("passDialog"));
            QVERIFY(choose(dialog, "passKind", 0));
            QVERIFY(enter(dialog, "passAllowance", "0.5"));
            driver.shoot("passes-2-levels");
            QVERIFY(press(dialog, "computePassButton"));
        });
        driver.key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        QCOMPARE(workbenchOf(driver).path.stored()->sources.size(), std::size_t(1));
        QTest::qWait(500);
        driver.shoot("passes-3-roughed");

        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", 2));
            QVERIFY(dialog.findChild<QWidget*>("passInside")->isVisible());
            QVERIFY(enter(dialog, "passAllowance", "0"));
            driver.shoot("passes-4-profile");
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_COMPARE_WITH_TIMEOUT(workbenchOf(driver).path.stored()->sources.size(), std::size_t(2), 30000);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        const std::size_t points = evaluatedIn(driver)->path.points.size();

        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr && evaluatedIn(driver)->path.points.size() < points,
                                 30000);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(workbenchOf(driver).path.stored() == nullptr);
        QVERIFY(!workbenchOf(driver).setup.locked());
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr && evaluatedIn(driver)->path.points.size() == points,
                                 30000);
        QVERIFY(workbenchOf(driver).setup.locked()); // the passes belong to this part in this stock

        // Changed in place; the dialog shows the request that was made. Then changed back.
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.windowTitle(), QString("Change a pass"));
            QCOMPARE(dialog.findChild<QComboBox*>("passKind")->currentIndex(), 0);
            QVERIFY(enter(dialog, "passAllowance", "0.2"));
            driver.shoot("passes-4a-change");
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("passChangeButton0"));
        QTRY_VERIFY_WITH_TIMEOUT(workbenchOf(driver).path.passes().front().allowance == 0.2, 30000);
        QCOMPARE(workbenchOf(driver).path.passes().size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr && evaluatedIn(driver)->path.points.size() == points,
                                 30000);
        QCOMPARE(workbenchOf(driver).path.passes().front().allowance, 0.5);

        // Measured on request; the user determines the order.
        QVERIFY(driver.clickOn("measurePassesButton"));
        QTRY_VERIFY_WITH_TIMEOUT(driver.window().findChild<QLabel*>("passMeasured1") != nullptr, 30000);
        QVERIFY(driver.window().findChild<QLabel*>("passMeasured0")->text().contains("in air"));
        QVERIFY(driver.window().findChild<QLabel*>("passMeasured1")->text().contains("Stock left"));
        QTest::qWait(300);
        driver.shoot("passes-4c-measured");
        const std::int64_t second = workbenchOf(driver).path.passes().back().id;
        QVERIFY(driver.clickOn("passUpButton1"));
        QTRY_COMPARE(workbenchOf(driver).path.passes().front().id, second);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(workbenchOf(driver).path.passes().back().id == second);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);

        QVERIFY(driver.clickOn("passRemoveButton0"));
        QTRY_COMPARE(workbenchOf(driver).path.passes().size(), std::size_t(1));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.settle()); // an evaluation that was started before must not change the list of passes
        QCOMPARE(workbenchOf(driver).path.passes().size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        QCOMPARE(evaluatedIn(driver)->path.points.size(), points);
        QTest::qWait(300);
        driver.shoot("passes-4b-two-passes");
        QVERIFY(postProgram(driver));
        QTest::qWait(500);
        driver.shoot("passes-5-posted");
        QVERIFY(workbenchOf(driver).program.program()->report.findings.empty());
    }

    /// A saved project opens again with its workpiece and its path.
    BURIN_ONLY_IN_LONG_RUNS void passesAreKept() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "flat-10"));
        QVERIFY(driver.step(JobStep::path));
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", 3));
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        const std::size_t points = evaluatedIn(driver)->path.points.size();
        const QString file = driver.folder().filePath("passes.burin");
        QVERIFY(saveAs(driver, file));
        drop(driver.window(), file);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr && evaluatedIn(driver)->path.points.size() == points,
                                 30000);
    }

    /// Rows are laid out by the scallop height that is entered, not by the proposed step-over.
    void aScallopHeightReplacesTheStepOver() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "ball-6"));
        QVERIFY(driver.step(JobStep::path));
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", 4));
            QVERIFY(enter(dialog, "passScallop", "0.1"));
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_COMPARE_WITH_TIMEOUT(workbenchOf(driver).path.passes().size(), std::size_t(1), 30000);
        const Result<PassRequest> request =
            passRequestFromJson(workbenchOf(driver).path.passes().front().request, "the pass");
        QVERIFY(request);
        QCOMPARE(request->scallop, 0.1);
        QCOMPARE(request->stepOver, 0.0);
    }

    /// A plate with a hole of 6 mm: the drill is offered only drilling, which finds the hole. The result is drawn and
    /// described before it is computed.
    BURIN_ONLY_IN_LONG_RUNS void aHoleIsDrilled() {
        WindowDriver driver;
        QVERIFY(hasPlateWithHole(driver, 6.0));
        Workbench& workbench = workbenchOf(driver);
        QVERIFY(hasTool(driver, "drill-6"));
        QVERIFY(driver.step(JobStep::path));
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.findChild<QComboBox*>("passKind")->count(), 1);
            QVERIFY(dialog.findChild<QLabel*>("passHoles")->text().contains("1 × 6.00"));
            QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QLabel*>("passPreview")->text().contains("about"), 30000);
            QCOMPARE(workbench.passPreview.preview()->strokes.size(), std::size_t(1));
            QTest::qWait(500);
            driver.shoot("passes-7-drilling");
            QVERIFY(enter(dialog, "passPeck", "2"));
            QTRY_VERIFY(workbench.passPreview.preview()->strokes.size() > 3);
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);
        QVERIFY(workbench.passPreview.preview() == nullptr); // replaced by the pass itself
        QTest::qWait(500);
        driver.shoot("passes-8-drilled");
        QVERIFY(postProgram(driver));
        QVERIFY(workbench.program.program()->report.findings.empty());
        QVERIFY(workbench.program.program()->report.gougeMax < 0.01);
    }

    /// A hole of 8 mm is picked by a click and drilled at 6.8 mm; then the thread mill offers its thread, which is
    /// milled. A second click removes the hole, and so does the key Del in the list.
    BURIN_ONLY_IN_LONG_RUNS void aPickedHoleGetsAThread() {
        WindowDriver driver;
        QVERIFY(hasPlateWithHole(driver, 8.0));
        Workbench& workbench = workbenchOf(driver);
        QVERIFY(hasTool(driver, "drill-6.8"));
        QVERIFY(driver.step(JobStep::path));
        driver.window().viewport().setStandardView(StandardView::isometric);
        QTest::qWait(600);
        const Box part = workbench.setup.part()->box();
        const glm::dvec3 mouth(glm::dvec2(part.centre()), part.high.z);
        const auto clickHole = [&](const glm::dvec2& aside) {
            Viewport& viewport = driver.window().viewport();
            QTest::mouseClick(&viewport, Qt::LeftButton, {},
                              viewport.project(mouth + glm::dvec3(aside, 0.0)).toPoint());
        };
        const auto pickInView = [&] {
            driver.whenDialogStands([&](QWidget& dialog) {
                QVERIFY(!dialog.findChild<QListWidget*>("passPickedHoles")->isVisible());
                QVERIFY(press(dialog, "pickHolesButton"));
            });
            QVERIFY(driver.clickOn("newPassButton"));
            QTRY_VERIFY(driver.message().contains("Click the holes"));
            clickHole({1.0, -1.0});
            QTRY_VERIFY2(driver.message().contains("1 hole is picked"), qPrintable(driver.message()));
        };
        pickInView();
        clickHole({0.0, 0.0});
        QTRY_VERIFY2(driver.message().contains("Removed") && driver.message().contains("0 holes"),
                     qPrintable(driver.message()));
        clickHole({12.0, 0.0}); // beside it
        QTRY_VERIFY2(driver.message().contains("no round upright hole"), qPrintable(driver.message()));
        clickHole({0.0, 0.0});
        QTRY_VERIFY(driver.message().contains("8.000"));
        QTest::qWait(300);
        driver.shoot("passes-11-picked-hole");
        bool answered = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* list = dialog.findChild<QListWidget*>("passPickedHoles");
            QVERIFY(list->isVisible());
            QCOMPARE(list->count(), 1);
            QVERIFY2(list->item(0)->text().contains("8.000"), qPrintable(list->item(0)->text()));
            QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QLabel*>("passPreview")->text().contains("about"), 30000);
            QTest::qWait(300);
            driver.shoot("passes-12-picked-holes");
            list->setFocus();
            list->setCurrentRow(0);
            QTest::keyClick(list, Qt::Key_Delete);
            QTRY_VERIFY(!list->isVisible());
            answered = press(dialog, "cancelPassButton");
        });
        driver.window().viewport().setFocus();
        driver.key(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(answered, 40000);
        QVERIFY(workbench.path.stored() == nullptr);

        pickInView();
        QVERIFY(driver.step(JobStep::stock)); // another step ends picking
        QVERIFY(driver.window().viewport().interactiveTool() == nullptr);
        QVERIFY(driver.step(JobStep::path));

        pickInView();
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(enter(dialog, "passHoleDepth", "20")); // also through the stock below
            QVERIFY(press(dialog, "computePassButton"));
        });
        driver.window().viewport().setFocus();
        driver.key(Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 30000);

        QVERIFY(hasTool(driver, "thread-mill-m8"));
        driver.whenDialogStands([&](QWidget& dialog) {
            QCOMPARE(dialog.findChild<QComboBox*>("passKind")->count(), 1);
            QCOMPARE(dialog.findChild<QComboBox*>("passThreadSize")->currentText(), QString("M8"));
            QCOMPARE(dialog.findChild<QuantityField*>("passThreadDepth")->value(), 0.0); // not that of the drill
            QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QLabel*>("passPreview")->text().contains("about"), 30000);
            QCOMPARE(workbench.passPreview.preview()->strokes.size(), std::size_t(1));
            QTest::qWait(500);
            driver.shoot("passes-13-thread");
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr && evaluatedIn(driver)->path.toolId == "thread-mill-m8",
                                 30000);
        QTest::qWait(500);
        driver.shoot("passes-14-threaded");
        QVERIFY(postProgram(driver));
        QVERIFY(workbench.program.program()->report.findings.empty());
        QVERIFY(workbench.program.program()->report.gougeMax < 0.02);
        const std::string text = workbench.program.program()->text;
        QVERIFY(text.find("G3") != std::string::npos); // helical arcs, anticlockwise
    }

    /// A click on a stud makes the thread an external one; the dialog shows it, and without the mark it shows the
    /// holes.
    void aPickedStudGetsAnExternalThread() {
        WindowDriver driver;
        QVERIFY(hasPlate(driver, writePlateWithStud(driver)));
        Workbench& workbench = workbenchOf(driver);
        QVERIFY(hasTool(driver, "thread-mill-m8"));
        QVERIFY(driver.step(JobStep::path));
        Viewport& viewport = driver.window().viewport();
        viewport.setStandardView(StandardView::isometric);
        QTest::qWait(600);
        const Box part = workbench.setup.part()->box();
        const glm::dvec3 top(glm::dvec2(part.centre()), part.high.z);
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(dialog.findChild<QLabel*>("passHoles")->text().contains("no round upright holes"));
            QVERIFY(!dialog.findChild<QCheckBox*>("passExternal")->isChecked());
            QVERIFY(press(dialog, "pickHolesButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_VERIFY(driver.message().contains("Click the holes or the studs"));
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(top).toPoint());
        QTRY_VERIFY2(driver.message().contains("stud") && driver.message().contains("1 stud is picked"),
                     qPrintable(driver.message()));
        QTest::qWait(300);
        driver.shoot("passes-15-picked-stud");
        bool answered = false;
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* external = dialog.findChild<QCheckBox*>("passExternal");
            auto* list = dialog.findChild<QListWidget*>("passPickedHoles");
            QVERIFY(external->isChecked());
            QCOMPARE(list->count(), 1);
            QVERIFY2(list->item(0)->text().contains("6.376"), qPrintable(list->item(0)->text()));
            QVERIFY(dialog.findChild<QLabel*>("passHoles")->text().contains("studs of the part: 1 × 6.376"));
            QTest::qWait(300);
            driver.shoot("passes-16-external-thread");
            external->click();
            QTRY_VERIFY(!list->isVisible()); // studs are no holes
            QVERIFY(dialog.findChild<QLabel*>("passHoles")->text().contains("no round upright holes"));
            answered = press(dialog, "cancelPassButton");
        });
        viewport.setFocus();
        driver.key(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(answered, 40000);
    }

    /// Another kind and another value are previewed at once; for tabs, their size can be entered.
    void whatIsAskedForIsPreviewed() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "flat-6"));
        QVERIFY(driver.step(JobStep::path));
        driver.whenDialogStands([&](QWidget& dialog) {
            auto* preview = dialog.findChild<QLabel*>("passPreview");
            const auto length = [&] {
                const PassPreview* shown = workbenchOf(driver).passPreview.preview();
                return shown != nullptr && !workbenchOf(driver).passPreview.busy() ? shown->length : 0.0;
            };
            QVERIFY(choose(dialog, "passKind", 2));
            QTRY_VERIFY_WITH_TIMEOUT(preview->text().contains("about"), 30000);
            QVERIFY(!dialog.findChild<QWidget*>("passTabWidth")->isVisible());
            auto* tabs = dialog.findChild<QSpinBox*>("passTabs");
            tabs->setFocus();
            QTest::keyClick(tabs, Qt::Key_Up);
            QTest::keyClick(tabs, Qt::Key_Up);
            QVERIFY(dialog.findChild<QWidget*>("passTabWidth")->isVisible());
            QTest::qWait(500);
            driver.shoot("passes-9-tabs");
            QVERIFY(choose(dialog, "passKind", 0));
            QTest::qWait(200);
            QTRY_VERIFY(length() > 0.0);
            const double before = length();
            QVERIFY(enter(dialog, "passStepOver", "1.2")); // half of the proposed value
            QTest::qWait(200);
            QTRY_VERIFY2(length() > 1.5 * before && length() < 2.5 * before, qPrintable(QString::number(length())));
            QTest::qWait(300);
            driver.shoot("passes-10-preview");
            QVERIFY(choose(dialog, "passKind", 1)); // a pocket without an area
            QTRY_VERIFY(preview->text().isEmpty());
            QVERIFY(workbenchOf(driver).passPreview.preview() == nullptr);
            QVERIFY(press(dialog, "cancelPassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QVERIFY(workbenchOf(driver).passPreview.preview() == nullptr);
        QVERIFY(workbenchOf(driver).path.stored() == nullptr);
    }

    /// Show me plays the sample stroke, the directions and rows; Esc stops it and leaves the dialog open; nothing
    /// changes.
    void aPassIsShownBeingMade() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "ball-6"));
        QVERIFY(driver.step(JobStep::path));
        Workbench& workbench = workbenchOf(driver);
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", static_cast<int>(PassKind::flow)));
            QList<bool> parts;   // of the film so far: whether the tool is shown
            const QObject watch; // ends before the list
            connect(&workbench.passShow, &PassShow::moved, &watch, [&] {
                const bool shown = workbench.passShow.picture()->tip.has_value();
                if (parts.isEmpty() || parts.back() != shown) parts << shown;
            });
            QVERIFY(press(dialog, "passShowMeButton"));
            QTRY_VERIFY_WITH_TIMEOUT(!parts.isEmpty(), 30000);
            driver.shoot("passes-20-show-stroke");
            QTRY_VERIFY_WITH_TIMEOUT(parts.size() > 1, 30000);
            driver.shoot("passes-21-show-directions");
            QTRY_VERIFY_WITH_TIMEOUT(parts.size() > 2, 30000);
            QCOMPARE(parts, (QList<bool>{true, false, true}));
            driver.shoot("passes-22-show-rows");
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QVERIFY(!workbench.passShow.showing());
            QVERIFY(dialog.isVisible());
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QVERIFY(!dialog.isVisible());
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QVERIFY(workbench.path.stored() == nullptr);
        QVERIFY(workbench.passPreview.preview() == nullptr);
    }

    /// A recorded line leads a pass that blends into it. When the path mills the line no more, the pass is
    /// marked, and one key computes it again; undone, it is out of date again, until the take is back as well.
    BURIN_ONLY_IN_LONG_RUNS void aChangedStrokeMarksItsPass() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "ball-6"));
        QVERIFY(recordLine(driver, {-10.0, -5.0}, {10.0, -5.0}));
        Workbench& workbench = workbenchOf(driver);
        QTRY_VERIFY_WITH_TIMEOUT(workbench.passes.possible(), 90000);
        QVERIFY(driver.step(JobStep::path));
        QVERIFY(newPath(driver));
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", static_cast<int>(PassKind::flow)));
            auto* hand = dialog.findChild<QWidget*>("passHand");
            auto* lines = dialog.findChild<QComboBox*>("passLines");
            lines->setFocus();
            QTest::keyClicks(lines, "s"); // strokes of the take
            QCOMPARE(lines->currentIndex(), 2);
            QVERIFY(choose(dialog, "passHand", 2));
            QVERIFY(dialog.findChild<QWidget*>("passOverlap")->isVisible());
            QVERIFY(enter(dialog, "passOverlap", "0.8"));
            QVERIFY(enter(dialog, "passStepOver", "2"));
            QTest::qWait(500);
            driver.shoot("passes-23-hand-strokes");
            QVERIFY(hand->height() >= hand->sizeHint().height()); // the dialog has room for all of its fields
            QVERIFY(press(dialog, "computePassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QTRY_COMPARE_WITH_TIMEOUT(workbench.path.passes().size(), std::size_t(1), 90000);
        const Result<PassRequest> request = passRequestFromJson(workbench.path.passes().front().request, "the pass");
        QVERIFY(request);
        QCOMPARE(request->hand, HandStrokes::blend);
        QCOMPARE(request->overlap, 0.8);
        QCOMPARE(request->leads.size(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 90000);
        QVERIFY(driver.settle());
        QVERIFY(workbench.passRefresher.outdated().empty());
        // The pass is led by the take, but has no more strokes of the hand before it.
        const std::int64_t pass = workbench.path.passes().front().id;
        workbench.path.millTake(workbench.mill.takes().front().id, false);
        QTRY_COMPARE_WITH_TIMEOUT(workbench.passRefresher.outdated(), std::vector<std::int64_t>{pass}, 90000);
        QTRY_VERIFY(driver.window().findChild<QLabel*>("passOutdated0") != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(workbench.passRefresher.possible(), 90000);
        QTest::qWait(300);
        driver.shoot("passes-24-out-of-date");
        driver.key(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY_WITH_TIMEOUT(workbench.path.passes().front().id != pass, 90000);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 90000);
        QVERIFY(driver.settle());
        QVERIFY(workbench.passRefresher.outdated().empty());
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(workbench.path.passes().front().id, pass);
        QTRY_COMPARE_WITH_TIMEOUT(workbench.passRefresher.outdated(), std::vector<std::int64_t>{pass}, 90000);
        // Another pass that begins before it can be computed is not superseded, and doesn't cancel it.
        QTRY_VERIFY_WITH_TIMEOUT(workbench.passRefresher.possible(), 90000);
        bool otherEnded = false;
        workbench.passRefresher.refresh();
        workbench.tasks().start(
            TaskKind::pass, QStringLiteral("another pass"),
            [](Progress&) -> Result<void> {
                QThread::msleep(300);
                return {};
            },
            [&](const Result<void>& ended) { otherEnded = static_cast<bool>(ended); });
        QTRY_VERIFY_WITH_TIMEOUT(workbench.path.passes().front().id != pass, 90000);
        QVERIFY(otherEnded);
        QTRY_VERIFY_WITH_TIMEOUT(evaluatedIn(driver) != nullptr, 90000);
        QVERIFY(driver.settle());
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(workbench.path.passes().front().id, pass);
        driver.key(Qt::Key_Z, Qt::ControlModifier); // the take is back
        QTRY_VERIFY_WITH_TIMEOUT(workbench.passRefresher.outdated().empty(), 90000);
    }

    /// An impossible request is reported in the dialog, where it can be corrected; so is an invalid drawing.
    void whatCannotBeIsToldInTheDialog() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(hasTool(driver, "flat-6"));
        QVERIFY(driver.step(JobStep::path));
        driver.whenDialogStands([&](QWidget& dialog) {
            QVERIFY(choose(dialog, "passKind", 1)); // a pocket without an area
            QVERIFY(press(dialog, "computePassButton"));
            QTRY_VERIFY(dialog.isVisible() && dialog.findChild<QWidget*>("passNotice")->isVisible());
            driver.shoot("passes-6-pocket-without-an-area");
            QVERIFY(press(dialog, "cancelPassButton"));
        });
        QVERIFY(driver.clickOn("newPassButton"));
        QVERIFY(workbenchOf(driver).path.stored() == nullptr);
    }
};

BURIN_TEST(TestWindowPasses, QApplication)

} // namespace burin::tst_window_passes

#include "tst_window_passes.moc"
