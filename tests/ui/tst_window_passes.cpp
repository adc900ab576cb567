// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Computed passes: by mouse and keys.
#include "core/setup/setup.h"
#include "tests/ui/window_steps.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QtTest>

using namespace burin;
using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

/// By the keyboard, as the list opens under software drawing at its own pace.
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
    /// A block of 40 x 30 x 20 mm: roughed, its outline finished, undone and redone, and posted; without a recording.
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
        QVERIFY(workbenchOf(driver).setup.locked()); // the passes are of this part in this stock

        // Changed in its place, as it was asked for; and back.
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

        QVERIFY(driver.clickOn("passRemoveButton0"));
        QTRY_COMPARE(workbenchOf(driver).path.passes().size(), std::size_t(1));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver.settle()); // what was evaluated meanwhile comes too late to say what the path is made of
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

    /// What is kept opens again with its workpiece and its path.
    void passesAreKept() {
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

    /// A scallop height that is entered is what rows are laid by, not the step-over that was proposed.
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

    /// A request that can't be is told where it can be mended; a drawing that is none, too.
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

QTEST_MAIN(TestWindowPasses)
#include "tst_window_passes.moc"
